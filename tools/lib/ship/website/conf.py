"""The configuration of Sphinx for the site of tools/make site, which copies it beside the pages."""

import re

project = "hashnoise"
copyright = "The hashnoise authors"
extensions = ["myst_parser", "sphinx_copybutton"]
myst_heading_anchors = 6  # links to headings are those of GitHub
html_theme = "furo"
html_title = "hashnoise"
html_copy_source = False
html_show_sourcelink = False
html_use_index = False
html_extra_path = ["extra"]
html_static_path = ["static"]
html_css_files = ["phone.css"]
highlight_language = "none"
suppress_warnings = ["misc.highlighting_failure"]  # for example where a preprocessor stands before a shader

# Languages that Pygments does not know, and those whose colours fit them.
LIKE = {"metal": "cpp", "osl": "c", "gdshader": "glsl", "godot": "glsl", "slang": "hlsl", "wesl": "wgsl", "tsl": "js"}
# Code that is indented has no language on the page.
SHADER = re.compile(r"(?:return )?(?:vec[234]|mix|hn_\w+)\(|vec[234] \w+ = ")
SHELL = re.compile(r"(?:\w+=\S+ )*(?:hashnoise/|build/|cd |cp |\./)*(?:tools/\w+|cmake|meson|conan|git|gh|gpg|pip|python3|c\+\+|npm|"
                   r"glslangValidator|slangc|hn-conform|examples|\S+/hn-conform)\b")


def language_of(text: str) -> str:
    """The language of code whose page names none."""
    first = text.lstrip().partition("\n")[0]
    return "glsl" if SHADER.match(first) else "sh" if SHELL.match(first) else "json" if first.startswith('{"') else "none"


def setup(app):  # Sphinx calls it
    from docutils import nodes
    from pygments.lexers import get_lexer_by_name

    def name_languages(_, document):
        for block in document.findall(nodes.literal_block):
            if block.get("language", "none") in ("none", "default"):
                block["language"] = language_of(block.astext())

    for name, like in LIKE.items():
        app.add_lexer(name, type(get_lexer_by_name(like)))
    app.connect("doctree-read", name_languages)
