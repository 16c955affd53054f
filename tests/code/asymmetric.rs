{
// glam: p' = M p with column vectors, right-handed view space looking along -n, NDC -1 to 1, as in the lecture notes
// glam stores matrices by columns: m[j][i] is row i, column j
// angles in radians, vertical
let view = glam::dcamera::rh::view::look_at_mat4(glam::dvec3(3.0, 4.0, 5.0), glam::dvec3(0.5, -1.0, 0.25), glam::dvec3(0.1, 1.0, -0.2));
let projection = glam::dcamera::rh::proj::opengl::frustum(-0.5, 0.75, -0.25, 0.5, 0.75, 40.0);
(view, projection)
}
