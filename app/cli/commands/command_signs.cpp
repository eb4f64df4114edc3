#include "app/cli/commands/commands.h"
#include "app/cli/input.h"
#include "app/cli/work.h"
#include "core/presets/presets.h"
#include "core/signs/tree_signs.h"
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace ramure::cli {

namespace {

constexpr CommandText signsText = {
    "signs", "the signs of wood and growth of a tree", "INPUT",
    "Measures what tells wood and growth from a drawing, against what is published of it.",
    "One row a sign: its value, the band in which foresters find it, and \"inside\", \"outside\", \"no "
    "band\" "
    "(nothing is published of the species), \"absent\" (the tree has too little of it) or \"not modelled\" "
    "(the "
    "program does not make it). A tree that grows by years is grown several times for it: in the open, with "
    "light "
    "from one side, from a leaning seedling, and with a limb cut. The exit code does not depend on what is "
    "found. "
    "With --json an array of trees, each with its \"name\" and its \"signs\"."};

struct NamedSigns
{
    QString name;
    std::vector<TreeSign> signs;
};

bool isMeasured(const TreeSign& sign)
{
    return sign.state == SignState::Inside || sign.state == SignState::Outside ||
           sign.state == SignState::NoBand;
}

bool hasBand(const TreeSign& sign)
{
    return sign.state == SignState::Inside || sign.state == SignState::Outside;
}

QString bandOf(const TreeSign& sign)
{
    if (!hasBand(sign))
        return {};
    const auto number = [](double value) { return QString::number(value, 'g', 3); };
    return std::isfinite(sign.high) ? QStringLiteral("%1 - %2").arg(number(sign.low), number(sign.high))
                                    : QStringLiteral("from %1").arg(number(sign.low));
}

QString textOf(const NamedSigns& tree)
{
    QString out = tree.name + u'\n';
    for (const TreeSign& sign : tree.signs) {
        const QString value = isMeasured(sign) ? QString::number(sign.value, 'f', 2) : QString();
        out += QStringLiteral("%1 %2  %3 %4 %5\n")
                   .arg(QLatin1String(sign.label), -23)
                   .arg(value, 7)
                   .arg(bandOf(sign), -12)
                   .arg(QLatin1String(nameOf(sign.state)), -13)
                   .arg(fromText(sign.note) +
                        (*sign.unit ? QStringLiteral(" (%1)").arg(QLatin1String(sign.unit)) : QString()));
    }
    return out;
}

QJsonObject jsonOf(const NamedSigns& tree)
{
    QJsonArray rows;
    for (const TreeSign& sign : tree.signs) {
        QJsonObject row{{QStringLiteral("sign"), QLatin1String(sign.key)},
                        {QStringLiteral("label"), QLatin1String(sign.label)},
                        {QStringLiteral("state"), QLatin1String(nameOf(sign.state))},
                        {QStringLiteral("note"), fromText(sign.note)}};
        if (*sign.unit)
            row.insert(QStringLiteral("unit"), QLatin1String(sign.unit));
        if (isMeasured(sign))
            row.insert(QStringLiteral("value"), sign.value);
        if (hasBand(sign)) {
            row.insert(QStringLiteral("low"), sign.low);
            if (std::isfinite(sign.high))
                row.insert(QStringLiteral("high"), sign.high);
        }
        rows.append(row);
    }
    return {{QStringLiteral("name"), tree.name}, {QStringLiteral("signs"), rows}};
}

void addSignsOptions(CommandLine& line)
{
    line.addInputOptions();
    line.addNodeOption();
    line.add({QStringLiteral("json")}, QStringLiteral("Prints one JSON array."));
}

const Preset* speciesOf(const Node& node)
{
    const auto preset = std::ranges::find(presets(), std::string_view(node.preset), &Preset::name);
    return preset == presets().end() ? nullptr : &*preset;
}

Expected<int> runSigns(const CommandLine& line)
{
    const auto measured = [&]() -> Expected<std::vector<NamedSigns>> {
        const Work work("signs");
        auto input = loadInput(line);
        RAMURE_TRY(input);
        RAMURE_TRY(keepNodes(*input, line.values("node")));
        if (!input->scene())
            return fail(ErrorCode::Invalid, "\"%1\" is a mesh: only trees have signs of growth",
                        {line.arguments().front().toStdString()});
        const auto trees = treesOf(*input->scene());
        RAMURE_TRY(trees);
        std::vector<NamedSigns> out;
        for (const Node* node : *trees) {
            if (!input->scene()->isShown(node->id))
                continue;
            const auto all = double(trees->size()), done = double(out.size());
            auto signs = treeSigns(node->params, speciesOf(*node),
                                   work.progress().part(done / all, (done + 1.0) / all));
            RAMURE_TRY(signs);
            out.push_back({fromText(node->name), std::move(*signs)});
        }
        return out;
    }();
    RAMURE_TRY(measured);
    if (line.has("json")) {
        QJsonArray all;
        for (const NamedSigns& tree : *measured)
            all.append(jsonOf(tree));
        RAMURE_TRY(printJson(all));
        return exitGood;
    }
    QStringList texts;
    for (const NamedSigns& tree : *measured)
        texts.append(textOf(tree));
    RAMURE_TRY(print(texts.join(u'\n')));
    return exitGood;
}

} // namespace

const Command signsCommand{signsText, &addSignsOptions, &runSigns};

} // namespace ramure::cli
