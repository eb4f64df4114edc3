#include "core/qt/document/edit_script.h"

#include "core/base/plain_text.h"
#include "core/params/recipe.h"
#include "core/params/tree_edit_table.h"
#include "core/pipeline/freeze.h"
#include "core/pipeline/tree_pipeline.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_edits.h"
#include "core/recipe/edit_context.h"
#include "core/scene/edit_shapes.h"

#include <QCoreApplication>
#include <QJsonDocument>

namespace ramure {

namespace {

/// A line may name a solid of the scene as the shape to prune to.
Expected<json::ScriptEdits> withSolids(const QJsonObject& line, const Scene& scene, NodeId tree)
{
    const QJsonValue named = line.value(QLatin1String("shape")).toObject().value(QLatin1String("mesh"));
    if (!named.isString())
        return json::readScriptEdits(line);
    const std::string name = named.toString().toStdString();
    const auto solid = std::ranges::find(scene.nodes(), name, &Node::name);
    auto shape = meshShape(scene, tree, solid == scene.nodes().end() ? noNode : solid->id);
    if (!shape) {
        shape.error().path = "shape.mesh";
        return fail(std::move(shape.error()));
    }
    QJsonObject whole = line;
    whole.insert(QLatin1String("shape"), json::writeShape(*shape));
    return json::readScriptEdits(whole);
}

Expected<json::ScriptEdits> parsed(const QByteArray& line, const Scene& scene, NodeId tree)
{
    QJsonParseError problem;
    const QJsonDocument json = QJsonDocument::fromJson(line, &problem);
    if (json.isObject())
        return withSolids(json.object(), scene, tree);
    auto error = fail(ErrorCode::Syntax, RAMURE_NOOP("a JSON object is expected here"));
    error.value().column = problem.error == QJsonParseError::NoError ? 1 : problem.offset + 1;
    return error;
}

/// The edits of one line, added to all before.
Expected<void> addLine(const json::ScriptEdits& script, EditContext& context, std::vector<TreeEdit>& list)
{
    for (const TreeEdit& wanted : script.edits) {
        auto edit = context.prepared(wanted, script.inTreeSpace);
        RAMURE_TRY(edit);
        if (std::ranges::find(list, edit->id, &TreeEdit::id) != list.end()) {
            auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("every edit needs a name of its own"));
            error.value().path = "id";
            return error;
        }
        if (edit->id == 0)
            edit->id = newEditId(list, *edit);
        const bool isOn = std::exchange(edit->enabled, true);
        if (isOn)
            if (auto made = context.apply(*edit); !made)
                return made;
        edit->enabled = isOn;
        list.push_back(std::move(*edit));
    }
    return {};
}

/// The lists of a script so far, and the tree that they lead to.
struct Replay
{
    NodeParams tree; ///< as it was, but for the steps that it has now
    EditContext context{Skeleton(), {}};
    TreePipeline pipeline{};

    Expected<void> renew()
    {
        const auto grown = pipeline.evaluate(tree, Stage::Skeleton);
        RAMURE_TRY(grown);
        context = EditContext(*grown->grown, tree.edits, nullptr, treeSeed(tree));
        return {};
    }
};

tl::unexpected<Error> refusedAt(const char* path, const char* text)
{
    auto error = fail(ErrorCode::Invalid, text);
    error.value().path = path;
    return error;
}

/// {"step": "#3", ...}: switches a step of the recipe on or off, changes its values, moves, removes or
/// freezes it with all before.
Expected<void> changeStep(QJsonObject line, Replay& replay)
{
    std::vector<TreeEdit>& list = replay.tree.edits;
    const auto step = findStep(replay.tree, line.take(QLatin1String("step")).toString().toStdString());
    RAMURE_TRY(step);
    if (line == QJsonObject{{QStringLiteral("freeze"), true}}) {
        auto frozen = frozenBehind(replay.tree, *step);
        RAMURE_TRY(frozen);
        list = std::move(*frozen);
        return replay.renew();
    }
    if (*step == 0)
        return refusedAt("step", RAMURE_NOOP("a recipe keeps the source that it begins with"));
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(*step - 1);
    const QJsonValue enabled = line.take(QLatin1String("enabled")),
                     remove = line.take(QLatin1String("remove"));
    const QJsonValue move = line.take(QLatin1String("move")), values = line.take(QLatin1String("values"));
    if (!line.isEmpty())
        return refusedAt(line.begin().key().toUtf8().constData(),
                         RAMURE_NOOP("enabled, values, move, remove or freeze is expected here"));
    at->enabled = enabled.toBool(at->enabled);
    if (values.isObject())
        RAMURE_TRY(json::readStepValues(values.toObject(), *at));
    if (remove.toBool()) {
        list.erase(at);
    } else if (move.isDouble()) {
        const qint64 to = move.toInteger(0), count = std::ssize(list);
        if (to < 2 || to > count + 1)
            return refusedAt("move", RAMURE_NOOP("a step goes to a number from 2 to that of the last step"));
        TreeEdit moved = std::move(*at);
        list.erase(at);
        list.insert(list.begin() + (to - 2), std::move(moved));
    }
    return replay.renew();
}

Expected<void> runLine(const QByteArray& line, const Scene& scene, NodeId tree, Replay& replay)
{
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    if (object.contains(QLatin1String("step")))
        return changeStep(object, replay);
    const auto edits = parsed(line, scene, tree);
    RAMURE_TRY(edits);
    return addLine(*edits, replay.context, replay.tree.edits);
}

} // namespace

Expected<void> replayEdits(Document& document, NodeId id, const QByteArray& script)
{
    const Node* const tree = document.scene().find(id);
    if (!tree || tree->kind != NodeKind::Tree)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no such tree"));
    Replay replay{tree->params};
    RAMURE_TRY(replay.renew());
    int number = 0;
    const PlainText plain({script.constData(), static_cast<std::size_t>(script.size())});
    const QByteArray text(plain.view().data(), static_cast<qsizetype>(plain.view().size()));
    for (const QByteArray& line : text.split('\n')) {
        ++number;
        if (line.trimmed().isEmpty())
            continue;
        if (auto done = runLine(line, document.scene(), id, replay); !done) {
            done.error().line = number;
            return done;
        }
    }
    const int change = static_cast<int>(std::ssize(replay.tree.edits) - std::ssize(tree->params.edits));
    return edit::setTreeEdits(document, id, std::move(replay.tree.edits),
                              QCoreApplication::translate("ramure::DocumentCommand", "Shape %n limb(s)",
                                                          nullptr, std::max(change, 1)));
}

} // namespace ramure
