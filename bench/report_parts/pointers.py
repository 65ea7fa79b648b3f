"""Numbers of results.json on the page: each stands there with the place that it comes from (a JSON pointer)."""

import html
import json


def lookup(results, pointer):
    value = results
    for key in pointer.split("/")[1:]:
        key = key.replace("~1", "/").replace("~0", "~")
        value = value[int(key)] if isinstance(value, list) else value[key]
    return value


def pointer(*keys):
    return "".join("/" + str(key).replace("~", "~0").replace("/", "~1") for key in keys)


def three_digits(value):
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def two_digits(value):
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.2g}"


def whole(value):
    return f"{value:,.0f}"


class Numbers:
    def __init__(self, results):
        self.results = results

    def value(self, *keys):
        return lookup(self.results, pointer(*keys))

    def show(self, *keys, form=three_digits, scale=1):
        """The number at these keys, times `scale`; a dash where there is none."""
        value = self.value(*keys)
        if value is None:
            return "–"
        return (f'<data value="{html.escape(json.dumps(value))}" data-pointer="{html.escape(pointer(*keys))}" '
                f'data-scale="{scale}">{form(value * scale)}</data>')

    def count(self, *keys):
        return self.show(*keys, form=whole)

    def percent(self, *keys):
        value = self.value(*keys)
        form = whole if value is None or abs(value) >= 0.1 else two_digits
        return self.show(*keys, form=form, scale=100) + ("" if value is None else " %")


def table(head, rows, caption=""):
    """head: cells of the first row; rows: lists of cells. All are HTML; the first cell of a row names it."""
    lines = ["<div class=wide><table>"]
    if caption:
        lines.append(f"<caption>{caption}</caption>")
    lines.append("<thead><tr>" + "".join(f"<th>{c}</th>" for c in head) + "</tr></thead><tbody>")
    for row in rows:
        lines.append(f"<tr><th>{row[0]}</th>" + "".join(f"<td>{c}</td>" for c in row[1:]) + "</tr>")
    lines.append("</tbody></table></div>")
    return "\n".join(lines)


def listing(items):
    return "<ul>" + "".join(f"<li>{item}</li>" for item in items) + "</ul>"
