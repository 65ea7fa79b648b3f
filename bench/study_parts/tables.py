"""The numbers of results.json as tables in files of their own."""

import csv
import os

FILES = {
    "results.json": "everything",
    "points.csv": "errors and time of every run of the mesh sweeps",
    "parameters.csv": "the same of the parameter sweeps",
    "orders.csv": "orders of convergence with their residuals",
    "cheapest.csv": "which setting reaches an error first, and what each costs",
    "candidates.csv": "error and time over those of the plain algorithm, at the report's resolution",
    "ensemble.csv": "the oblique rod",
}


def rows_of_points(part, curve, place, more=()):
    for point in curve["points"]:
        for quantity in part["quantities"]:
            yield [part["name"], *more, curve["method"], point[place], point["elements"], point["steps"], point["seconds"],
                   quantity["key"], point["errors"].get(quantity["key"]), point["failure"]]


def points(results):
    rows = [["study", "method", "mesh", "elements", "steps", "seconds", "quantity", "error", "failure"]]
    for part in results["studies"]:
        for curve in part["curves"]:
            rows += rows_of_points(part, curve, "mesh")
    return rows


def parameters(results):
    rows = [["study", "key", "mesh", "method", "value", "elements", "steps", "seconds", "quantity", "error", "failure"]]
    for part in results["studies"]:
        for sweep in part["sweeps"]:
            for curve in sweep["curves"]:
                rows += rows_of_points(part, curve, "value", (sweep["key"], sweep["mesh"]))
    return rows


def orders(results):
    rows = [["study", "method", "quantity", "order", "residual_decades"]]
    for part in results["studies"]:
        for curve in part["curves"]:
            for key, order in curve["orders"].items():
                if order:
                    rows.append([part["name"], curve["method"], key, order["order"], order["residual"]])
    return rows


def cheapest(results):
    rows = [["study", "quantity", "error", "method", "seconds", "at_most", "is_cheapest"]]
    for part in results["studies"]:
        for key, best in part["cheapest"].items():
            for i, aim in enumerate(part["aims"]):
                for curve in part["curves"]:
                    cost = curve["costs"][key][i]
                    if cost:
                        rows.append([part["name"], key, aim, curve["method"], cost["seconds"], cost["at_most"],
                                     best[i]["method"] == curve["method"]])
    return rows


def candidates(results):
    rows = [["study", "quantity", "mesh", "method", "error_plain", "error", "error_plain_over_own", "time_over_plain",
             "times_faster_at_the_same_error", "met"]]
    for entry in results["candidates"]:
        for row in entry["rows"]:
            rows.append([entry["study"], entry["quantity"], entry["mesh"], row["method"], row["error"]["plain"],
                         row["error"]["own"], row["gain"], row["time"], row["faster"], row["met"]])
    return rows


def ensemble(results):
    rows = [["method", "step", "mass_left", "energy_error", "seconds"]]
    for row in (results["ensemble"] or {"rows": []})["rows"]:
        rows += [[row["method"], m["step"], m["left"], m["energy"], m["seconds"]] for m in row["members"]]
    return rows


def write(results, folder):
    for name, rows in (("points.csv", points(results)), ("parameters.csv", parameters(results)),
                       ("orders.csv", orders(results)), ("cheapest.csv", cheapest(results)),
                       ("candidates.csv", candidates(results)), ("ensemble.csv", ensemble(results))):
        with open(os.path.join(folder, name), "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(rows)
