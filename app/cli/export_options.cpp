#include "app/cli/export_options.h"

namespace ramure::cli {

void addExportOptions(CommandLine& line, OptionFlag who)
{
    for (const ExportOption& option : exportOptions())
        if (option.is(who))
            line.add({QLatin1String(option.name)},
                     QString::fromUtf8(option.help)
                         .replace(QLatin1String("%1"),
                                  QLatin1String(who == ofBatch ? option.inBatch : option.inExport)),
                     QLatin1String(option.values));
}

Expected<ExportOptions> exportOptionsOf(const CommandLine& line, OptionFlag who, ExportOptions usual)
{
    ExportOptions out = std::move(usual);
    for (const ExportOption& option : exportOptions())
        if (option.is(who) && line.has(option.name))
            RAMURE_TRY(readOption(option, out, line.value(option.name).toStdString()));
    if (who == ofImport)
        return out;
    const bool hasLevels = line.has("levels") || line.has("budget");
    for (const char* name : {"switch", "billboard"})
        if (line.has(name) && !hasLevels)
            return fail(ErrorCode::Invalid, "--%1 needs --levels", {name});
    if (!line.has("levels"))
        out.levels.count = static_cast<std::int64_t>(out.levels.budgets.size());
    if (hasLevels)
        RAMURE_TRY(checkLevels(out.levels));
    return out;
}

std::optional<FileSpace> spaceGiven(const CommandLine& line, const ExportOptions& options)
{
    const bool isGiven = line.has("up") || line.has("unit") || line.has("scale");
    return isGiven ? std::optional(options.space) : std::nullopt;
}

} // namespace ramure::cli
