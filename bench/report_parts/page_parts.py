"""What every page is made of: its style, sections, figures, and the frame around them."""

import html

from .pointers import listing

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #1d2733; max-width: 72rem; margin: 2rem auto; padding: 0 1.2rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.25rem; margin-top: 2.6rem; border-bottom: 1px solid #ccd3da; }
h3 { font-size: 1.05rem; margin-bottom: .3rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; margin: .8rem 0; }
caption { text-align: left; color: #52606d; padding-bottom: .3rem; }
th, td { padding: .2rem .7rem; border-bottom: 1px solid #e4e8ec; text-align: right; vertical-align: top; }
th:first-child, .text td { text-align: left; } thead th { border-bottom: 2px solid #9aa5b1; } tbody th { font-weight: 600; }
img { max-width: 100%; } figure { margin: 1rem 0; } figcaption { color: #52606d; font-size: .88rem; }
.met { color: #1b7f4b; font-weight: 600; } .missed { color: #b3261e; font-weight: 600; }
code, pre { font: .85rem/1.4 ui-monospace, monospace; } pre { overflow-x: auto; background: #f4f6f8; padding: .6rem; }
details { margin: .3rem 0; } summary { cursor: pointer; } .lead { font-size: 1.05rem; }
"""


def escape(text):
    return html.escape(str(text))


def image(data, caption):
    return (f'<figure><img alt="{escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{escape(caption)}</figcaption></figure>")


def judgement(met):
    return "<span class=met>reached</span>" if met else "<span class=missed>missed</span>"


def section(name, title, *content):
    return f'<section id="{name}"><h2>{title}</h2>\n' + "\n".join(content) + "\n</section>"


def repeat_section(command, form, files):
    """How the page is made again. files: {name: what it is} of those beside it."""
    return section("repeat", "Again",
                   f"<p><code>bench/{command}{' --quick' if form == 'quick' else ''}</code> makes this page. Every number on it is "
                   "in results.json, at the place named by its <code>data-pointer</code>. Beside it:</p>",
                   listing(f'<a href="{name}">{name}</a>: {escape(text)}' for name, text in files.items()))


def frame(title, heading, sections):
    """The page as a whole; title is plain text, all else HTML."""
    return ("<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8>"
            '<meta name=viewport content="width=device-width, initial-scale=1">'
            f"<title>{escape(title)}</title><style>{STYLE}</style></head><body>"
            f"<h1>{heading}</h1>\n" + "\n".join(sections) + "</body></html>\n")
