#include "core/qt/document/project/project_json.h"

#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"
#include "core/qt/document/project/project_arm.h"
#include "core/qt/document/project/project_edits.h"
#include "core/qt/document/project/project_mesh.h"
#include "core/qt/document/project/project_places.h"
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

static QJsonObject writeBranches(const Node& node)
{
    QJsonObject branches;
    for (const auto& [key, values] : node.params.branches) {
        QJsonObject branch;
        const glm::dvec3 bend = values.bendRad + 0.0; // -0 is written as 0
        if (values.rollRad != 0.0)
            branch.insert(QStringLiteral("roll"), values.rollRad);
        if (bend != glm::dvec3(0.0))
            branch.insert(QStringLiteral("bend"), QJsonArray{bend.x, bend.y, bend.z});
        if (!branch.isEmpty() && !values.place.way.empty())
            branch.insert(QStringLiteral("place"), writePlace(values.place));
        if (!branch.isEmpty())
            branches.insert(branchKey(key), branch);
    }
    return branches;
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
    if (const QJsonObject branches = writeBranches(node); !branches.isEmpty())
        object.insert(QStringLiteral("branches"), branches);
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
        for (const auto step :
             {&NodeReader::readIds, &NodeReader::readKind, &NodeReader::readState, &NodeReader::readParams,
              &NodeReader::readBranches, &NodeReader::readTreeEdits, &NodeReader::readArm,
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
    static Expected<glm::dvec3> readBend(const QJsonValue& value, const std::string& place)
    {
        const QJsonArray array = value.toArray();
        const bool numbers =
            array.size() == 3 && array[0].isDouble() && array[1].isDouble() && array[2].isDouble();
        if (!value.isUndefined() && !numbers)
            return failAt(place + ".bend", ErrorCode::Invalid,
                          RAMURE_NOOP("three numbers are expected here"));
        return glm::dvec3(array[0].toDouble(), array[1].toDouble(), array[2].toDouble());
    }
    Expected<void> readBranch(const QString& key, const QJsonValue& value, QJsonObject& unknown)
    {
        const std::string place = "branches." + key.toStdString();
        const auto number = branchKeyFromText(key);
        if (!number)
            return failInside(place, number.error());
        if (!value.isObject())
            return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        QJsonObject object = value.toObject();
        const QJsonValue roll = object.take(QLatin1String("roll"));
        if (!roll.isDouble() && !roll.isUndefined())
            return failAt(place + ".roll", ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
        const auto bend = readBend(object.take(QLatin1String("bend")), place);
        RAMURE_TRY(bend);
        auto at = readPlace(object.take(QLatin1String("place")));
        if (!at)
            return failInside(place + ".place", std::move(at.error()));
        if (const BranchParams values{roll.toDouble(0.0), *bend, std::move(*at)}; !values.changesNothing())
            m_node.params.branches.emplace(*number, values);
        if (!object.isEmpty())
            unknown.insert(key, object);
        return {};
    }
    Expected<void> readBranches()
    {
        if (m_node.kind == NodeKind::Unknown) // it may mean something else there
            return {};
        const auto object = takeObject("branches");
        RAMURE_TRY(object);
        QJsonObject unknown;
        for (auto it = object->begin(); it != object->end(); ++it)
            if (auto done = readBranch(it.key(), it.value(), unknown); !done)
                return done;
        if (!unknown.isEmpty())
            m_rest.insert(QStringLiteral("branches"), unknown);
        return {};
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
