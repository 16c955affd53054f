//! A reference picture for each stage of the pipeline: small, exact, of one thing.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::camera::Camera;
use camera_lab::figure::read::parse;
use camera_lab::picture::Renderer;
use camera_lab::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_words::{Lang, pictures};

use crate::common::rendered::assert_rendered;

const SIZE: Size = Size { width: 160, height: 120, scale: 1.0 };
const LIGHT: &str = "[[scene.lights]]\nkind = \"directional\"\ndirection = [-1, -1.2, -1.6]\n";

/// The image of a figure, compared with `stage_NAME.png`.
#[track_caller]
fn assert_stage(name: &str, figure: &str) {
    let figure = parse(figure).unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    let scene =
        scene_of(&figure, &mut camera_lab::scene::no_files, &camera_lab::progress::Progress::default()).unwrap();
    let (scene, labels) = (SharedScene::new(scene), pictures::labels(Lang::En));
    let planned = Request::of(&figure, View::Image, &camera, &scene, labels, SIZE);
    let forced = Request { force_all_stages: true, ..planned.clone() };
    let mut renderer = Renderer::default();
    let planned = renderer.pixels(&planned).unwrap();
    assert_rendered(&format!("stage_{name}"), &planned);
    assert!(planned == renderer.pixels(&forced).unwrap(), "{name}: the plan changed a pixel");
}

/// One ball with a light, in a shading.
fn ball(style: &str) -> String {
    format!(
        "[camera]\nposition = [0, 0, 4]\nview_angle = 30\nnear = 2\nfar = 8\n\
         [[scene.objects]]\nname = \"ball\"\nshape = \"sphere\"\nsegments = 12\ncolor = \"#4477aa\"\n{LIGHT}\
         [style]\nhidden_lines = \"hidden\"\n{style}\n"
    )
}

#[test]
fn traversal_multiplies_the_transforms_down_the_tree() {
    // The hand hangs on the arm, which hangs on the trunk: both turn with it.
    let part = |name: &str, parent: &str, rest: &str| {
        format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\n{parent}{rest}\n")
    };
    assert_stage(
        "traverse",
        &format!(
            "[camera]\nposition = [1, 1, 9]\nview_angle = 34\nnear = 4\nfar = 14\n{}{}{}{LIGHT}",
            part("trunk", "", "scale = [1, 2, 1]\nrotate = [0, 0, 20]\ncolor = \"#4477aa\""),
            part("arm", "parent = \"trunk\"\n", "translate = [1, 0.4, 0]\nscale = [1, 0.2, 0.6]\ncolor = \"#ee8866\""),
            part(
                "hand",
                "parent = \"arm\"\n",
                "translate = [0.75, 0, 0]\nrotate = [0, 0, 45]\nscale = [0.3, 1.5, 0.8]\ncolor = \"#228833\""
            ),
        ),
    );
}

#[test]
fn light_on_faces() {
    assert_stage("light_flat", &ball("shading = \"flat\""));
}

#[test]
fn light_on_vertices_is_interpolated() {
    assert_stage("light_gouraud", &ball("shading = \"gouraud\""));
}

#[test]
fn light_on_pixels_by_interpolated_normals() {
    assert_stage("light_phong", &ball("shading = \"phong\""));
}

#[test]
fn a_point_light_is_near() {
    let figure =
        ball("shading = \"phong\"").replace(LIGHT, "[[scene.lights]]\nkind = \"point\"\nposition = [0.8, 0.5, 0.9]\n");
    assert_stage("light_point", &figure);
}

#[test]
fn wireframe_has_edges_only() {
    assert_stage("wireframe", &ball("shading = \"wireframe\""));
}

#[test]
fn an_oblique_window_shifts_the_picture() {
    let figure = ball("shading = \"flat\"")
        .replace("view_angle = 30\n", "window = { left = -0.4, right = 1.0, bottom = -0.75, top = 0.3 }\n");
    assert_stage("oblique_window", &figure);
}

#[test]
fn a_parallel_projection_has_no_divide() {
    let boxes: String = (0..3)
        .map(|i| {
            let z = -2 * i;
            format!("[[scene.objects]]\nname = \"box {i}\"\nshape = \"box\"\ntranslate = [{}, 0, {z}]\n", i - 1)
        })
        .collect();
    let figure = |projection: &str| {
        format!(
            "[camera]\nposition = [3, 3, 6]\nview_angle = 40\nheight = 5.4\nnear = 2\nfar = 16\nprojection = \"{projection}\"\n{boxes}{LIGHT}"
        )
    };
    assert_stage("divide", &figure("perspective"));
    assert_stage("no_divide", &figure("parallel"));
}

#[test]
fn clipping_opens_what_the_near_plane_cuts() {
    let figure = "[camera]\nposition = [2.2, 1.9, 2.4]\nview_angle = 60\nnear = 3.0\nfar = 9\n\
                  [[scene.objects]]\nname = \"torus\"\nshape = \"torus\"\nscale = [3.4, 3.4, 3.4]\ncolor = \"#ee8866\"\n";
    assert_stage("clip_near", &format!("{figure}{LIGHT}"));
}

#[test]
fn hidden_surfaces_by_depth_where_faces_cross() {
    let bar = |name: &str, turn: i32, height: f64, color: &str| {
        format!(
            "[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\nrotate = [0, {turn}, 0]\nscale = [2.2, {height}, 0.8]\ncolor = \"{color}\"\n"
        )
    };
    let figure = format!(
        "[camera]\nposition = [1, 2.4, 5]\nview_angle = 36\nnear = 2\nfar = 9\n{}{}{LIGHT}",
        bar("a", 20, 0.8, "#4477aa"),
        bar("b", 80, 0.5, "#ee8866")
    );
    for visibility in ["depth-buffer", "painter", "bsp"] {
        let style = format!("[style]\nvisibility = \"{visibility}\"\nhidden_lines = \"hidden\"\n");
        assert_stage(&format!("hidden_surfaces_{}", visibility.replace('-', "_")), &format!("{figure}{style}"));
    }
}

#[test]
fn blending_shows_the_surface_behind() {
    let figure = "[camera]\nposition = [1.2, 1.4, 5]\nview_angle = 30\nnear = 2\nfar = 9\n\
                  [[scene.objects]]\nname = \"solid\"\nshape = \"box\"\ntranslate = [-0.3, 0, -0.8]\ncolor = \"#ee8866\"\n\
                  [[scene.objects]]\nname = \"glass\"\nshape = \"sphere\"\ntranslate = [0.2, 0, 0.4]\ncolor = \"#4477aa80\"\n";
    assert_stage("blend", &format!("{figure}{LIGHT}"));
}

#[test]
fn antialiasing_smooths_edges() {
    for samples in [1, 4, 16] {
        assert_stage(&format!("antialias_{samples}"), &ball(&format!("antialias = {samples}")));
    }
}

#[test]
fn hidden_lines_three_ways() {
    let boxes = "[camera]\nposition = [2.4, 1.8, 4]\nview_angle = 38\nnear = 2\nfar = 9\n\
                 [[scene.objects]]\nname = \"box\"\nshape = \"box\"\ncolor = \"#88ccee\"\n";
    for hidden in ["dashed", "hidden", "shown"] {
        assert_stage(&format!("lines_{hidden}"), &format!("{boxes}{LIGHT}[style]\nhidden_lines = \"{hidden}\"\n"));
    }
}
