"""What follows from points of (seconds, error): the efficient frontier, orders of convergence, what an error costs."""

import numpy as np


def frontier(points):
    """Indices of the points of which no other one is as fast and as accurate, from the fastest on.

    points: (seconds, error); None in place of an error: the run failed."""
    order = sorted((i for i, (_, error) in enumerate(points) if error is not None), key=lambda i: points[i])
    found = []
    for i in order:
        if not found or points[i][1] < points[found[-1]][1]:
            found.append(i)
    return found


def order(sizes, errors):
    """(slope, residual) of log error over log element size by least squares; None with less than three points.

    residual: root of the mean square of the deviations, in decades of the error."""
    pairs = [(h, e) for h, e in zip(sizes, errors) if e is not None and e > 0]
    if len({h for h, _ in pairs}) < 3:
        return None
    x, y = np.log10(np.array(pairs)).T
    slope, intercept = np.polyfit(x, y, 1)
    return {"order": float(slope), "residual": float(np.sqrt(np.mean((y - slope * x - intercept) ** 2)))}


def cost(points, aim):
    """Seconds at which a curve reaches an error and keeps it on all finer meshes, between its points on logarithmic
    scales; {"seconds", "at_most"} or None where it is not reached. Nothing is continued beyond the points: where the
    coarsest mesh is good enough its time is an upper bound.

    points: (seconds, error) from coarse to fine."""
    points = [(s, e) for s, e in points if e is not None]
    if not points:
        return None
    above = [i for i, (_, error) in enumerate(points) if error > aim]
    if not above:
        return {"seconds": points[0][0], "at_most": True}
    last = above[-1]
    if last + 1 == len(points):
        return None
    (s0, e0), (s1, e1) = points[last], points[last + 1]
    if e1 <= 0:
        return {"seconds": s1, "at_most": True}
    part = (np.log(aim) - np.log(e0)) / (np.log(e1) - np.log(e0))
    return {"seconds": float(np.exp(np.log(s0) + part * (np.log(s1) - np.log(s0)))), "at_most": False}


NOISE = 0.1  # of a time: what is that close is not cheaper


def cheapest(curves, aim):
    """The curve that reaches an error first. curves: {title: points}, of which the first one is named wherever no other is
    cheaper by more than noise. {"method", "seconds", "at_most"} or None."""
    costs = {title: cost(points, aim) for title, points in curves.items()}
    reached = {title: c for title, c in costs.items() if c is not None}
    if not reached:
        return None
    least = min(c["seconds"] for c in reached.values())
    best = next(title for title, c in reached.items() if c["seconds"] <= least * (1 + NOISE))
    return {"method": best, **reached[best]}
