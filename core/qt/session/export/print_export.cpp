#include "core/qt/session/export/print_export.h"

#include "core/io/formats/file_format.h"
#include "core/qt/session/export/scene_counts.h"

namespace ramure {

Expected<ScenePrint> printScene(EvaluatedScene scene, const ExportOptions& which, const PrintOptions& options,
                                const Progress& progress)
{
    RAMURE_TRY(checkPrint(options));
    const Node* tree = nullptr;
    for (const Node& node : scene.scene().nodes()) {
        if (node.kind != NodeKind::Tree || !isExported(scene.scene(), which, node))
            continue;
        if (tree)
            return fail(ErrorCode::Invalid,
                        RAMURE_NOOP("one tree at a time is printed, and there are several: "
                                    "choose one"));
        tree = &node;
    }
    if (!tree)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is no visible tree to print"));
    const bool hasLeaves = options.leaves != PrintLeaves::Off;
    const auto result =
        scene.tree(*tree, hasLeaves ? Stage::Foliage : Stage::Simplified, progress.part(0.0, 0.05));
    if (!result)
        return fail(named(*tree, result.error()));
    auto printed = printTree(result->simplified->skeleton, scene.params(*tree), options,
                             progress.part(0.05, 1.0), result->foliage.get());
    RAMURE_TRY(printed);
    return ScenePrint{tree->name, std::move(*printed)};
}

FileSpace printSpace()
{
    FileSpace space;
    space.up = UpAxis::Z;
    space.unit = *lengthUnitNamed("mm");
    return space;
}

Expected<void> writePrint(const std::string& path, const ScenePrint& print, const FileSpace& space,
                          const WriteOptions& options, const Progress& progress)
{
    const auto format = findFormat(path, FormatUse::Write, options.ascii);
    RAMURE_TRY(format);
    ExportScene scene = sceneOfMeshes({}, barkMaterial());
    scene.nodes.push_back({print.name});
    scene.meshes.push_back({print.name, 0, print.tree.mesh});
    scene.frames.front().transforms.resize(1);
    scene.frames.front().bones.resize(1);
    scene.space = space;
    WriteOptions head = options;
    head.comment = space.comment();
    return (*format)->write(path, scene, head, progress);
}

} // namespace ramure
