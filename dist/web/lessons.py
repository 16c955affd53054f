"""Writes OUT/lessons.html, an index of all lessons, figures and exercises, each with a picture and a link to the page.

lessons.py PROGRAM OUT: PROGRAM is camera-lab for this system, which draws the pictures.
"""

import base64
import html
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import zlib

# The most bytes of the index, with its pictures.
MOST_BYTES = 2_000_000
SIZE = "240x180"
# Longer links aren't passed on whole: `MAX_LINK_CHARACTERS`.
MOST_CHARACTERS = 8000
ROOT = pathlib.Path(__file__).parents[2]
LANGS = ["en", "pt-BR"]
HEADINGS = {"lessons": ("Lessons", "Lições"), "figures": ("Figures", "Figuras"), "exercises": ("Exercises", "Exercícios")}

STYLE = """
  body { font: 16px/1.4 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em; background: #f6f6f6; color: #202020; }
  ul { display: grid; grid-template-columns: repeat(auto-fill, minmax(15em, 1fr)); gap: 1em; list-style: none; padding: 0; }
  li { background: #fff; border: 1px solid #ddd; padding: 0.6em; }
  img { display: block; width: 100%; height: auto; }
  a { color: inherit; }
  [lang="pt-BR"] { opacity: 0.75; }
  @media (prefers-color-scheme: dark) { body { background: #1b1b1b; color: #d8d8d8; } li { background: #262626; border-color: #444; } }
"""


def main(program: str, out: pathlib.Path) -> None:
    def run(*arguments: str) -> str:
        return subprocess.run([program, *arguments], check=True, capture_output=True, text=True, encoding="utf-8").stdout

    def listed(what: str) -> list[dict]:
        """The titles in each language, by language."""
        one, other = (json.loads(run(what, "list", "--format", "json", "--lang", lang)) for lang in LANGS)
        return [{"id": a["id"], "titles": (a["title"], b["title"])} for a, b in zip(one, other)]

    with tempfile.TemporaryDirectory() as scratch:
        picture_file = pathlib.Path(scratch) / "picture.jpg"

        def picture(figure: str | pathlib.Path) -> str:
            path = pathlib.Path(figure) if isinstance(figure, pathlib.Path) else pathlib.Path(scratch) / "figure.toml"
            if isinstance(figure, str):
                path.write_text(figure, encoding="utf-8")
            drawn = subprocess.run([program, "render", path, "--view", "image", "--size", SIZE, "-o", picture_file], capture_output=True)
            # A figure whose camera is impossible on purpose.
            return base64.b64encode(picture_file.read_bytes()).decode() if drawn.returncode == 0 else ""

        cards = {name: [] for name in HEADINGS}
        for lesson in listed("lesson"):
            steps = json.loads(run("lesson", "show", lesson["id"], "--format", "json"))["steps"]
            cards["lessons"].append(card(f"index.html?lesson={lesson['id']}", lesson["titles"], picture(steps[0]["figure"])))
        for path in sorted((ROOT / "assets/figures").rglob("*.toml")):
            text = path.read_text(encoding="utf-8")
            title = tomllib.loads(text).get("title", path.stem)
            titles = tuple(title.get(lang, path.stem) for lang in LANGS) if isinstance(title, dict) else (title, title)
            link = packed("figure", text)
            if len(link) <= MOST_CHARACTERS:
                cards["figures"].append(card(link, titles, picture(path)))
        for exercise in listed("exercise"):
            about = json.loads(run("exercise", "show", exercise["id"], "--format", "json"))
            title = json.dumps(exercise["titles"][0], ensure_ascii=False)
            named = f'{{ en = {title}, pt-BR = {json.dumps(exercise["titles"][1], ensure_ascii=False)} }}'
            lesson = f'id = "exercise"\ntitle = {named}\n\n[[step]]\ntitle = {named}\n[step.ask]\nexercise = "{exercise["id"]}"\nseed = 0\n'
            cards["exercises"].append(card(packed("lesson", lesson), exercise["titles"], picture(about["figure"])))
    body = "".join(
        f'<h2 id="{name}">{english} · <span lang="pt-BR">{portuguese}</span></h2>\n<ul>\n{"".join(cards[name])}</ul>\n'
        for name, (english, portuguese) in HEADINGS.items()
    )
    policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
    page = f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>Camera Lab</title>
<style>{STYLE}</style>
</head>
<body>
<h1><a href="index.html">Camera Lab</a></h1>
{body}</body>
</html>
"""
    data = page.encode()
    (out / "lessons.html").write_bytes(data)
    print(f"lessons.html: {len(data)} bytes, {', '.join(f'{len(cards[name])} {name}' for name in cards)}")
    if len(data) > MOST_BYTES:
        sys.exit(f"lessons.html: more than {MOST_BYTES} bytes")


def packed(what: str, text: str) -> str:
    """A link as the page reads it: zlib, then base64 for addresses."""
    return f"index.html#{what}=" + base64.urlsafe_b64encode(zlib.compress(text.encode(), 9)).decode().rstrip("=")


def card(link: str, titles: tuple[str, str], picture: str) -> str:
    english, portuguese = (html.escape(title) for title in titles)
    shown = f'<img src="data:image/jpeg;base64,{picture}" width="240" height="180" loading="lazy" alt="">' if picture else ""
    same = "" if english == portuguese else f'<br><span lang="pt-BR">{portuguese}</span>'
    return f'<li><a href="{html.escape(link)}">{shown}{english}</a>{same}</li>\n'


main(sys.argv[1], pathlib.Path(sys.argv[2]))
