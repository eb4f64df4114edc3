"""What an account of all axes says of a tree: [{id, parent, s, length}, ...], s being the distance along the parent."""

import math


def horton_ratio(axes):
    """How many times more streams of one order (Strahler 1957) there are than of the next, the mean over all orders."""
    children = {}
    for axis in axes:
        children.setdefault(axis["parent"], []).append(axis)
    counts = {}

    def order_of(axis):
        order, stream = 1, 1
        counts[1] = counts.get(1, 0) + 1
        for child in sorted(children.get(axis["id"], []), key=lambda one: -one["s"]):
            other = orders[child["id"]]
            if other == order:
                order += 1
                counts[order] = counts.get(order, 0) + 1
                stream = order
            elif other > order:
                order = stream = other
        return order

    orders = {}
    for axis in reversed(depth_first(axes, children)):
        orders[axis["id"]] = order_of(axis)
    highest = max(counts, default=0)
    if highest < 2:
        return None
    # The slope of the logarithms of the counts, as is usual.
    ranks = range(1, highest + 1)
    logs = [math.log(counts[rank]) for rank in ranks]
    middle, mean = sum(ranks) / highest, sum(logs) / highest
    slope = sum((rank - middle) * (log - mean) for rank, log in zip(ranks, logs))
    return math.exp(-slope / sum((rank - middle) ** 2 for rank in ranks))


def depth_first(axes, children):
    waiting, out = list(children.get(None, [])), []
    while waiting:
        axis = waiting.pop()
        out.append(axis)
        waiting += children.get(axis["id"], [])
    return out
