"""A ParaView that records what its state files do."""

import sys
import types


class Recorded:
    """Takes any member; knows those that it was made with."""

    def __init__(self, kind="", **members):
        self.kind = kind
        self.__dict__.update(members)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return self.__dict__.setdefault(name, Recorded(name))

    def __setattr__(self, name, value):
        self.__dict__[name] = Recorded(value) if name == "ClipType" else value  # ParaView makes a plane of its name

    def __call__(self, *arguments, **members):
        return Recorded(self.kind)


def run_state(path):
    """Runs a state file with a paraview.simple that records: {registration name or name of its own: object}."""
    made = {}

    def proxy(kind):
        def make(registrationName, **members):
            made[registrationName] = Recorded(kind, **members)
            return made[registrationName]
        return make

    simple = types.ModuleType("paraview.simple")
    for kind in ("PVDReader", "Threshold", "AppendDatasets", "Clip", "Reflect"):
        setattr(simple, kind, proxy(kind))
    simple._DisableFirstRenderCameraReset = simple.Render = lambda *_: None
    view = Recorded("view", ViewSize=[700, 900])
    simple.GetActiveViewOrCreate = lambda _: view
    simple.Show = lambda source, _: made.setdefault("shown", Recorded("shown", Input=source))
    simple.ColorBy = lambda _, array: made.__setitem__("ColorBy", array)
    simple.GetColorTransferFunction = lambda name: made.setdefault("colours", Recorded(name))
    simple.GetScalarBar = lambda *_: made.setdefault("bar", Recorded("bar"))
    simple.GetTimeKeeper = lambda: Recorded("times", TimestepValues=[0.0, 1.0])
    simple.GetAnimationScene = lambda: made.setdefault("animation", Recorded("animation"))
    package = types.ModuleType("paraview")
    package.simple = simple
    before = {name: sys.modules.get(name) for name in ("paraview", "paraview.simple")}
    sys.modules.update({"paraview": package, "paraview.simple": simple})
    try:
        exec(compile(path.read_text(), str(path), "exec"), {"__file__": str(path), "paraview": package})
    finally:
        for name, module in before.items():
            sys.modules.pop(name) if module is None else sys.modules.__setitem__(name, module)
    return {**made, "view": view}
