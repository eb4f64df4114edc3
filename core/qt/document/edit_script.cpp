#include "core/qt/document/edit_script.h"

#include "core/base/plain_text.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/project_edits.h"
#include "core/scene/edit_shapes.h"
#include "core/skeleton/edits/edit_context.h"

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
Expected<void> addLine(const json::ScriptEdits& script, EditContext& context, std::vector<TreeEdit>& list,
                       std::vector<TreeEdit>& added)
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
        list.push_back(*edit);
        added.push_back(std::move(*edit));
    }
    return {};
}

} // namespace

Expected<void> replayEdits(Document& document, NodeId id, const QByteArray& script)
{
    const Node* const tree = document.scene().find(id);
    if (!tree || tree->kind != NodeKind::Tree)
        return fail(ErrorCode::Unknown, RAMURE_NOOP("there is no such tree"));
    TreePipeline pipeline;
    const auto grown = pipeline.evaluate(tree->params, Stage::Skeleton);
    RAMURE_TRY(grown);
    EditContext context(*grown->grown, tree->params.edits);
    std::vector<TreeEdit> list = tree->params.edits, added;
    int number = 0;
    const PlainText plain({script.constData(), static_cast<std::size_t>(script.size())});
    const QByteArray text(plain.view().data(), static_cast<qsizetype>(plain.view().size()));
    for (const QByteArray& line : text.split('\n')) {
        ++number;
        if (line.trimmed().isEmpty())
            continue;
        auto done = parsed(line, document.scene(), id).and_then([&](const json::ScriptEdits& edits) {
            return addLine(edits, context, list, added);
        });
        if (!done) {
            done.error().line = number;
            return done;
        }
    }
    const auto put = edit::putTreeEdits(document, id, std::move(added));
    return put ? Expected<void>() : fail(put.error());
}

} // namespace ramure
