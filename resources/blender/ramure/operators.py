"""Adding a tree, growing it again, and stopping that."""
import time

import bpy

from . import build, program

BUDGET = 0.03  # s that the work may take of a moment of the window


class Work:
    """From the click to the finished tree, in steps that are short."""

    def __init__(self, holder):
        self.holder = holder
        self.growing = program.Growing(holder.ramure.words())
        self._steps = None
        self.longest = 0.0  # s of the longest step

    def go_on(self):
        """True when the tree is there. Raises program.Problem."""
        if not self.growing.is_done():
            return False
        if self._steps is None:
            path = self.growing.result()
            build.clear(self.holder)
            if self.holder.ramure.wind > 0.0:
                build.imported(self.holder, path)
                return True
            self._steps = build.Builder(self.holder, path).steps()
        begun = time.perf_counter()
        for _ in self._steps:
            spent = time.perf_counter() - begun
            self.longest = max(self.longest, spent)
            if spent > BUDGET:
                return False
        return True


def holder_of(thing):
    """The object that a tree hangs on; None: this is none."""
    while thing and not thing.ramure.is_tree:
        thing = thing.parent
    return thing


class Growth:
    """What both operators share: in the window a timer asks how far it is, without one it waits."""
    bl_options = {"REGISTER", "UNDO"}
    _work = None
    _timer = None

    def begin(self, context, holder):
        try:
            self._work = Work(holder)
        except program.Problem as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        if bpy.app.background:
            self._work.growing.wait()
            return self._finish(context)
        self._timer = context.window_manager.event_timer_add(0.05, window=context.window)
        context.window_manager.modal_handler_add(self)
        self._tell(context, f"Ramure grows {holder.name} …  Esc stops it")
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self._end(context)
            self.report({"INFO"}, "stopped: the tree stays as it was")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        return self._step(context)

    def _step(self, context):
        try:
            if not self._work.go_on():
                return {"RUNNING_MODAL"}
        except (program.Problem, ReferenceError, ValueError, KeyError, OSError) as problem:
            self._end(context)
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        self._end(context)
        return {"FINISHED"}

    def _finish(self, context):
        result = {"RUNNING_MODAL"}
        while result == {"RUNNING_MODAL"}:
            result = self._step(context)
        return result

    def cancel(self, context):
        self._end(context)

    def _tell(self, context, text):
        context.window_manager.ramure_state = text or ""
        if context.workspace:
            context.workspace.status_text_set(text)

    def _end(self, context):
        if self._work:
            self._work.growing.end()
        if self._timer:
            context.window_manager.event_timer_remove(self._timer)
            self._timer = None
        self._tell(context, None)


class RAMURE_OT_add(Growth, bpy.types.Operator):
    """Adds a tree of Ramure at the 3D cursor"""
    bl_idname = "ramure.add"
    bl_label = "Ramure Tree"

    species: bpy.props.StringProperty(name="Species", default="EnglishOak")
    seed: bpy.props.IntProperty(name="Seed", default=1, min=0)
    age: bpy.props.FloatProperty(name="Age", default=0.0, min=0.0, description="Years; 0: that of the species")

    def execute(self, context):
        holder = bpy.data.objects.new(self.species, None)
        holder.empty_display_type = "PLAIN_AXES"
        holder.location = context.scene.cursor.location
        holder.ramure.is_tree = True
        holder.ramure.species, holder.ramure.seed, holder.ramure.age = self.species, self.seed, self.age
        context.collection.objects.link(holder)
        for thing in context.selected_objects:
            thing.select_set(False)
        holder.select_set(True)
        context.view_layer.objects.active = holder
        result = self.begin(context, holder)
        if result == {"CANCELLED"}:
            bpy.data.objects.remove(holder)
        return result


class RAMURE_OT_grow(Growth, bpy.types.Operator):
    """Grows the tree anew from its settings"""
    bl_idname = "ramure.grow"
    bl_label = "Grow"

    @classmethod
    def poll(cls, context):
        return holder_of(context.active_object) is not None

    def execute(self, context):
        return self.begin(context, holder_of(context.active_object))


class RAMURE_OT_seed(bpy.types.Operator):
    """Another seed, and the tree grows anew"""
    bl_idname = "ramure.another"
    bl_label = "Another"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return holder_of(context.active_object) is not None

    def execute(self, context):
        holder_of(context.active_object).ramure.seed += 1
        grown = bpy.ops.ramure.grow("INVOKE_DEFAULT" if not bpy.app.background else "EXEC_DEFAULT")
        return {"CANCELLED"} if grown == {"CANCELLED"} else {"FINISHED"}


CLASSES = (RAMURE_OT_add, RAMURE_OT_grow, RAMURE_OT_seed)


def _in_menu(self, _context):
    self.layout.operator_context = "EXEC_DEFAULT"
    self.layout.operator(RAMURE_OT_add.bl_idname, icon="OUTLINER_OB_FORCE_FIELD")


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.VIEW3D_MT_mesh_add.append(_in_menu)


def unregister():
    bpy.types.VIEW3D_MT_mesh_add.remove(_in_menu)
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
