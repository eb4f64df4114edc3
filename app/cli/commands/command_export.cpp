#include "app/cli/commands/commands.h"
#include "app/cli/scene_export.h"
#include "app/cli/work.h"

namespace ramure::cli {

namespace {

constexpr CommandText exportText = {
    "export", "writes mesh files", "INPUT",
    "Writes a tree or a scene as meshes, or a mesh file in another format.",
    "The ending of FILE says the format: {formats}.\n"
    "All that is visible in a project is written together, where it stands in the "
    "world. Of several trees the objects are "
    "branches_1, leaves_1, fruit_1, branches_2 and so on; arms (their skin as it is "
    "at --time), terrains, primitives and imported meshes are objects with the names "
    "of their nodes. With --frames a .glb or .usda moves: one file with skins and an animation; of other "
    "formats each frame has a file. Files are written under "
    "another name and renamed: an error or Ctrl+C "
    "leaves the old file as it was."};

Expected<int> runExport(const CommandLine& line)
{
    const auto request = exportRequestOf(line, &printNote);
    RAMURE_TRY(request);
    ExportOutcome outcome;
    {
        const Work work("export");
        const Progress progress = work.progress();
        auto input = loadInput(line, progress.part(0.0, 0.0));
        RAMURE_TRY(input);
        TreePipeline pipeline; // its cache serves the second file
        auto done = exportInput(line, *request, *input, pipeline, progress);
        RAMURE_TRY(done);
        outcome = std::move(*done);
    }
    if (outcome.code != exitGood)
        printError(outcome.text);
    else
        RAMURE_TRY(print(outcome.text));
    return outcome.code;
}

} // namespace

const Command exportCommand{exportText, &addSceneExportOptions, &runExport};

} // namespace ramure::cli
