#include "app/cli/level_options.h"

#include "core/surface/bark/bark_maps.h"

namespace ramure::cli {

void addLevelOptions(CommandLine& line, const QString& others)
{
    line.add(
        {QStringLiteral("levels")},
        QStringLiteral("So many meshes of each tree, 1 to 8, for less and less triangles: fewer sides, "
                       "cross-sections and twigs, fewer and larger leaves. A .glb holds them all, as nodes "
                       "branches_LOD0, branches_LOD1 and so on that MSFT_lod names; %1. Without --budget the "
                       "first is the tree as it is, and "
                       "each further one has a quarter of the triangles or less.")
            .arg(others),
        QStringLiteral("N"));
    line.add(
        {QStringLiteral("budget")},
        QStringLiteral("Triangles of each level, bark, leaves and fruit together, separated by commas; each "
                       "less than the one before. Levels keep them within 2 %."),
        QStringLiteral("T0,T1,..."));
    line.add(
        {QStringLiteral("switch")},
        QStringLiteral("When each level but the first takes the place of the one before: distances in "
                       "metres, rising, for a vertical angle of view of 40°, such as 20,60; or shares of "
                       "the picture's height that the tree has, falling, such as 60%,30%. A .glb holds it "
                       "as MSFT_screencoverage. Without it 60%, and half of that for each further level."),
        QStringLiteral("D1,D2,..."));
}

Expected<LevelOptions> levelsFrom(const CommandLine& line)
{
    LevelOptions out;
    if (!line.has("levels") && !line.has("budget")) {
        if (line.has("switch"))
            return fail(ErrorCode::Invalid, "--switch needs --levels");
        return out;
    }
    const QStringList budgets =
        line.has("budget") ? line.value("budget").split(QLatin1Char(',')) : QStringList();
    for (const QString& budget : budgets) {
        bool isNumber = false;
        out.budgets.push_back(budget.trimmed().toLongLong(&isNumber));
        if (!isNumber)
            return fail(ErrorCode::Invalid, "--budget \"%1\": triangles, separated by commas, expected",
                        {line.value("budget").toStdString()});
    }
    bool isNumber = true;
    out.count = line.has("levels") ? line.value("levels").toLongLong(&isNumber) : budgets.size();
    if (!isNumber)
        return fail(ErrorCode::Invalid, "--levels \"%1\": 1 to %2 expected",
                    {line.value("levels").toStdString(), std::to_string(mostLevels)});
    auto fine = readSwitches(line.value("switch").toStdString(), out);
    if (fine)
        fine = checkLevels(out);
    RAMURE_TRY(fine);
    return out;
}

Expected<int> mapSizeFrom(const CommandLine& line)
{
    bool isNumber = false;
    const int size = line.value("map-size").toInt(&isNumber);
    if (!isNumber || (size != 0 && (size < leastBarkSize || size > mostBarkSize)))
        return fail(ErrorCode::Invalid, "--map-size \"%1\": 0, or %2 to %3 pixels expected",
                    {line.value("map-size").toStdString(), std::to_string(leastBarkSize),
                     std::to_string(mostBarkSize)});
    return size;
}

void addCompression(CommandLine& line)
{
    line.addDefault({QStringLiteral("compress")},
                    QStringLiteral("Of a .glb: meshopt makes it about a fifth as large "
                                   "(EXT_meshopt_compression and KHR_mesh_quantization), for web pages and "
                                   "engines that read that. Places are rounded to 1/65000 of how far they "
                                   "are from the origin, directions to a degree."),
                    QStringLiteral("meshopt|none"), QStringLiteral("none"));
}

Expected<bool> compressionFrom(const CommandLine& line)
{
    const QString given = line.value("compress");
    if (given != QLatin1String("none") && given != QLatin1String("meshopt"))
        return fail(ErrorCode::Unknown, "--compress \"%1\": meshopt or none expected", {given.toStdString()});
    return given == QLatin1String("meshopt");
}

void addWindOption(CommandLine& line)
{
    QString names;
    for (const WindProfileFacts& facts : windProfiles())
        names += QLatin1String(facts.name) + QLatin1Char('|');
    line.addDefault(
        {QStringLiteral("wind")},
        QStringLiteral(
            "Of the trees of a .glb: numbers of each vertex by which a game moves them. plain: _WIND, "
            "four numbers for any shader; crysis: vertex colours of CryEngine; unity: colours and "
            "second texture coordinates of Unity's Tree Creator; pivot-painter: second texture "
            "coordinates, and beside the file FILE_pivots.exr and FILE_axes.exr, for Unreal's "
            "PivotPainter2FoliageShader. The handbook has the formulas (Files)."),
        names + QStringLiteral("none"), QStringLiteral("none"));
}

Expected<WindProfile> windFrom(const CommandLine& line)
{
    auto profile = windProfileNamed(line.value("wind").toStdString());
    if (!profile)
        profile.error().path = "--wind";
    return profile;
}

} // namespace ramure::cli
