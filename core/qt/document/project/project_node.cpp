#include "core/qt/document/project/project_json.h"

#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"
#include "core/qt/document/project/project_arm.h"
#include "core/qt/document/project/project_edits.h"
#include "core/qt/document/project/project_mesh.h"
#include "core/qt/document/project/project_tracks.h"
#include "core/rig/arm/arm_shape.h"
#include "core/scene/kinds/node_kinds.h"

#include <QJsonArray>
#include <limits>

namespace ramure::json {

static QJsonObject writeParams(const Node& node)
{
    QJsonObject params;
    for (const ParamDef& def : paramTable()) {
        if (!hasParam(node.kind, def))
            continue;
        const ParamValue value = def.get(node.params);
        if (value != defaultValue(def))
            params.insert(QLatin1String(def.key), fromParam(value));
    }
    return params;
}

QJsonObject writeNode(const Node& node)
{
    QJsonObject object{
        {QStringLiteral("id"), qint64{node.id}},
        {QStringLiteral("name"), QString::fromStdString(node.name)},
    };
    if (node.kind != NodeKind::Unknown) // else it is in the extras
        object.insert(QStringLiteral("kind"), kindName(node));
    if (node.parent != noNode)
        object.insert(QStringLiteral("parent"), qint64{node.parent});
    if (!node.preset.empty())
        object.insert(QStringLiteral("preset"), QString::fromStdString(node.preset));
    if (!node.visible)
        object.insert(QStringLiteral("visible"), false);
    if (node.locked)
        object.insert(QStringLiteral("locked"), true);
    if (const QJsonObject params = writeParams(node); !params.isEmpty())
        object.insert(QStringLiteral("params"), params);
    if (node.kind == NodeKind::Tree && !node.params.edits.empty())
        object.insert(QStringLiteral("edits"), writeEdits(node.params.edits));
    if (node.kind == NodeKind::Arm && node.params.joints != defaultArmJoints())
        object.insert(QStringLiteral("joints"), writeJoints(node.params.joints));
    if (const QJsonObject tracks = writeTracks(node.animation); !tracks.isEmpty())
        object.insert(QStringLiteral("tracks"), tracks);
    if (node.mesh)
        object.insert(QStringLiteral("mesh"), writeMesh(*node.mesh));
    return merged(object, node.extras);
}

namespace {

/// Takes known keys out of an object one by one; what remains is unknown and kept.
class NodeReader
{
public:
    explicit NodeReader(const QJsonObject& object)
        : m_rest(object)
    {
    }

    Expected<Node> read()
    {
        for (const auto step : {&NodeReader::readIds, &NodeReader::readKind, &NodeReader::readState,
                                &NodeReader::readParams, &NodeReader::readTreeEdits, &NodeReader::readArm,
                                &NodeReader::readAnimation, &NodeReader::readGeometry})
            RAMURE_TRY((this->*step)());
        m_node.extras = extrasText(m_rest);
        followNames();
        return std::move(m_node);
    }

private:
    Expected<void> readId(const char* key, NodeId& id)
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        const qint64 number = value.toInteger(0);
        if (number < 1 || number > std::numeric_limits<NodeId>::max())
            return failAt(key, ErrorCode::Invalid,
                          RAMURE_NOOP("a whole number from 1 to 4294967295 is expected here"));
        id = static_cast<NodeId>(number);
        return {};
    }
    Expected<void> readIds()
    {
        if (m_rest.contains(QLatin1String("parent")))
            if (auto done = readId("parent", m_node.parent); !done)
                return done;
        return readId("id", m_node.id);
    }
    Expected<void> readKind()
    {
        const QJsonValue value = m_rest.take(QLatin1String("kind"));
        if (!value.isString())
            return failAt("kind", ErrorCode::Invalid, RAMURE_NOOP("a text is expected here"));
        const NodeKindRow* row = findKind(value.toString().toStdString());
        m_node.kind = row ? row->kind : NodeKind::Unknown;
        if (!row)
            m_rest.insert(QStringLiteral("kind"), value);
        return {};
    }
    Expected<void> readFlag(const char* key, bool& flag)
    {
        if (!m_rest.contains(QLatin1String(key)))
            return {};
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (!value.isBool())
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("true or false is expected here"));
        flag = value.toBool();
        return {};
    }
    Expected<void> readText(const char* key, std::string& text)
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (!value.isString() && !value.isUndefined())
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("a text is expected here"));
        text = value.toString().toStdString();
        return {};
    }
    Expected<void> readState()
    {
        for (const auto& [key, text] : {std::pair{"name", &m_node.name}, {"preset", &m_node.preset}})
            if (auto done = readText(key, *text); !done)
                return done;
        if (auto done = readFlag("visible", m_node.visible); !done)
            return done;
        return readFlag("locked", m_node.locked);
    }
    /// The object under \p key taken out; empty where there is none.
    Expected<QJsonObject> takeObject(const char* key)
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (!value.isObject() && !value.isUndefined())
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        return value.toObject();
    }
    Expected<void> readParam(const ParamDef& def, const QJsonValue& json)
    {
        const std::string place = std::string("params.") + def.key;
        const auto value = toParam(def, json);
        if (!value)
            return failInside(place, value.error());
        auto done = setParam(m_node.params, def, *value);
        if (!done)
            done.error().path = place; // the table only knows its key
        return done;
    }
    Expected<void> readParams()
    {
        auto object = takeObject("params");
        RAMURE_TRY(object);
        for (const ParamDef& def : paramTable()) {
            const QString key = QLatin1String(def.key);
            if (!hasParam(m_node.kind, def) || !object->contains(key))
                continue;
            if (auto done = readParam(def, object->take(key)); !done)
                return done;
        }
        if (!object->isEmpty())
            m_rest.insert(QStringLiteral("params"), *object);
        return {};
    }
    /// Where a species has come to grow by years, its tree of before has got another name.
    void followNames()
    {
        for (const char* older : {"1995", "Rules"}) {
            const auto found = std::ranges::find(presets(), m_node.preset + older, &Preset::name);
            if (found != presets().end() && found->params.generator.kind == m_node.params.generator.kind)
                m_node.preset = found->name;
        }
    }
    Expected<void> readTreeEdits()
    {
        if (m_node.kind != NodeKind::Tree || !m_rest.contains(QLatin1String("edits")))
            return {};
        const QJsonValue value = m_rest.take(QLatin1String("edits"));
        if (!value.isArray())
            return failAt("edits", ErrorCode::Invalid, RAMURE_NOOP("an array is expected here"));
        auto edits = readEdits(value.toArray());
        if (!edits)
            return failInside("edits", std::move(edits.error()));
        m_node.params.edits = std::move(*edits);
        return checkTreeEdits(m_node.params.edits);
    }
    Expected<void> readArm()
    {
        if (m_node.kind != NodeKind::Arm || !m_rest.contains(QLatin1String("joints")))
            return {};
        auto joints = readJoints(m_rest.take(QLatin1String("joints")));
        RAMURE_TRY(joints);
        m_node.params.joints = std::move(*joints);
        return {};
    }
    Expected<void> readAnimation()
    {
        auto object = takeObject("tracks");
        RAMURE_TRY(object);
        auto animation = readTracks(*object, m_node.kind);
        if (!animation)
            return failInside("tracks", std::move(animation.error()));
        m_node.animation = std::move(*animation);
        if (!object->isEmpty())
            m_rest.insert(QStringLiteral("tracks"), *object);
        return {};
    }
    Expected<void> readGeometry()
    {
        const bool wears = m_node.kind == NodeKind::Arm && m_rest.contains(QLatin1String("mesh"));
        if (m_node.kind != NodeKind::Mesh && !wears)
            return {};
        auto object = takeObject("mesh");
        RAMURE_TRY(object);
        auto mesh = readMesh(*object);
        if (!mesh)
            return failInside("mesh", std::move(mesh.error()));
        if (wears)
            RAMURE_TRY(checkArmMesh(*mesh)); // its path is "mesh"
        m_node.mesh = SharedValue<TriangleMesh>(std::move(*mesh));
        if (!object->isEmpty())
            m_rest.insert(QStringLiteral("mesh"), *object);
        return {};
    }

    QJsonObject m_rest;
    Node m_node;
};

} // namespace

Expected<Node> readNode(const QJsonObject& object)
{
    return NodeReader(object).read();
}

} // namespace ramure::json
