#include "core/qt/document/project/project_edits.h"

#include "core/params/tree_edit_table.h"
#include "core/qt/document/project/project_json.h"
#include "core/qt/document/project/project_places.h"
#include "core/skeleton/packed_skeleton.h"

#include <cmath>
#include <numbers>

namespace ramure::json {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

QJsonObject writeTarget(const EditTarget& target)
{
    QJsonObject object{{QStringLiteral("id"), branchKey(target.address)}};
    if (target.maker != 0)
        object.insert(QStringLiteral("maker"), branchKey(target.maker));
    if (!target.place.way.empty())
        object.insert(QStringLiteral("place"), writePlace(target.place));
    return object;
}

QJsonArray numbersOf(const glm::dvec3& v)
{
    return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; // -0 is written as 0
}

QJsonObject writeMeshShape(const EditShape& shape)
{
    QJsonArray points, triangles;
    for (const glm::dvec3& point : shape.points)
        points.append(numbersOf(point));
    for (const auto& t : shape.triangles)
        triangles.append(QJsonArray{qint64(t[0]), qint64(t[1]), qint64(t[2])});
    return {{QStringLiteral("points"), points}, {QStringLiteral("triangles"), triangles}};
}

QJsonArray writePoints(const std::vector<StrokePoint>& points)
{
    QJsonArray array;
    for (const StrokePoint& point : points) {
        QJsonArray numbers = numbersOf(point.position);
        if (point.radius != 0.0)
            numbers.append(point.radius);
        array.append(numbers);
    }
    return array;
}

/// A piece is [parent, axis, p0, p1, a0, a1] in one row of ten numbers; where it has more: what its end and
/// leaves are, and twelve numbers for each organ.
constexpr int limbNumbers = 10, organNumbers = 12;
constexpr int limbSawn = 1, limbBare = 2;

void appendOrgans(QJsonArray& row, const LimbPiece& piece)
{
    const int flags = (piece.sawn ? limbSawn : 0) | (piece.bare ? limbBare : 0);
    if (flags == 0 && piece.organs.empty())
        return;
    row.append(flags);
    for (const LimbOrgan& organ : piece.organs) {
        row.append(static_cast<int>(organ.organ));
        row.append(organ.share);
        row.append(organ.size);
        for (const glm::dvec3& v : {organ.offset, organ.heading, organ.up})
            for (const QJsonValue& number : numbersOf(v))
                row.append(number);
    }
}

QJsonArray writeLimb(const std::vector<LimbPiece>& limb)
{
    QJsonArray array;
    for (const LimbPiece& piece : limb) {
        QJsonArray numbers{qint64(piece.parent), qint64(piece.axis)};
        for (const glm::dvec3& v : {piece.p0, piece.p1})
            for (const QJsonValue& number : numbersOf(v))
                numbers.append(number);
        numbers.append(piece.a0);
        numbers.append(piece.a1);
        appendOrgans(numbers, piece);
        array.append(numbers);
    }
    return array;
}

/// What a value that is not written is. A bend without an end is all at its start, as in files from before
/// there were others.
TreeEdit usualEdit(EditOperation operation)
{
    TreeEdit usual = newStep(operation);
    if (operation == EditOperation::Bend)
        usual.to = 0.0;
    return usual;
}

/// The parameters of a step that are not those of a new one.
QJsonObject writeValues(const TreeEdit& edit, const TreeEdit& usual)
{
    QJsonObject values;
    for (const ParamDef* def : stepParams(edit.operation))
        if (const ParamValue value = def->get(*edit.values); value != def->get(*usual.values))
            values.insert(QLatin1String(def->key), fromParam(value));
    return values;
}

QJsonObject writeEdit(const TreeEdit& edit)
{
    const TreeEdit usual = usualEdit(edit.operation);
    const EditOperationInfo& info = infoOf(edit.operation);
    QJsonObject object{{QStringLiteral("id"), branchKey(edit.id)}};
    if (info.group != StepGroup::Unknown)
        object.insert(QStringLiteral("op"), QLatin1String(info.key));
    if (!edit.name.empty())
        object.insert(QStringLiteral("name"), QString::fromStdString(edit.name));
    if (!edit.enabled)
        object.insert(QStringLiteral("enabled"), false);
    if (edit.target.address != 0)
        object.insert(QLatin1String(info.targetKey), writeTarget(edit.target));
    if ((info.fields & editOther) && edit.other.address != 0)
        object.insert(QLatin1String(info.otherKey), writeTarget(edit.other));
    for (const EditNumber& number : editNumbers())
        if ((info.fields & number.field) && edit.*number.member != usual.*number.member)
            object.insert(QLatin1String(number.key), edit.*number.member);
    for (const EditVector& vector : editVectors())
        if ((info.fields & vector.field) && edit.*vector.member != usual.*vector.member)
            object.insert(QLatin1String(vector.key), numbersOf(edit.*vector.member));
    for (const EditFlag& flag : editFlags())
        if ((info.fields & flag.field) && edit.*flag.member != usual.*flag.member)
            object.insert(QLatin1String(flag.key), edit.*flag.member);
    if (info.fields & editOrgan)
        object.insert(QStringLiteral("organ"),
                      QLatin1String(editOrgans()[static_cast<std::size_t>(edit.organ)].key));
    if (info.fields & editShape)
        object.insert(QStringLiteral("shape"), writeShape(edit.shape));
    if ((info.fields & editPoints) || ((info.fields & editPath) && !edit.points.empty()))
        object.insert(QStringLiteral("points"), writePoints(edit.points));
    if ((info.fields & editLimb) && !edit.limb.empty())
        object.insert(QStringLiteral("limb"), writeLimb(edit.limb));
    if (edit.frozen)
        object.insert(QStringLiteral("tree"),
                      QString::fromLatin1(QByteArray::fromStdString(edit.frozen->bytes).toBase64()));
    if (const QJsonObject values = writeValues(edit, usual); !values.isEmpty())
        object.insert(QStringLiteral("values"), values);
    if (edit.version != 1 && info.group != StepGroup::Unknown)
        object.insert(QStringLiteral("version"), qint64(edit.version));
    return merged(object, edit.kept);
}

/// Takes known keys out of an object one by one: what remains is refused.
class EditReader
{
public:
    EditReader(QJsonObject object, bool isScript)
        : m_rest(std::move(object))
        , m_isScript(isScript)
    {
    }

    Expected<TreeEdit> read()
    {
        RAMURE_TRY(readHead());
        if (m_info->group == StepGroup::Unknown) {
            m_edit.kept = extrasText(m_rest);
            return std::move(m_edit);
        }
        for (const auto step :
             {&EditReader::readTargets, &EditReader::readNumbers, &EditReader::readVectors,
              &EditReader::readFlags, &EditReader::readOrgan, &EditReader::readShape, &EditReader::readPoints,
              &EditReader::readLimb, &EditReader::readFrozen, &EditReader::readValues})
            RAMURE_TRY((this->*step)());
        if (!m_rest.isEmpty())
            return failAt(m_rest.begin().key().toStdString(), ErrorCode::Unknown,
                          RAMURE_NOOP("\"%1\" has no such value"), {m_info->key});
        RAMURE_TRY(checkTreeEdit(m_edit));
        return std::move(m_edit);
    }

private:
    Expected<void> readHead()
    {
        const QString op = m_rest.value(QLatin1String("op")).toString();
        const qint64 version = m_rest.value(QLatin1String("version")).toInteger(1);
        m_info = editOperationOf(op.toStdString());
        if (!m_info && m_isScript)
            return failAt("op", ErrorCode::Unknown, RAMURE_NOOP("unknown operation \"%1\""),
                          {op.toStdString()});
        if (!m_info || version < 1 || version > m_info->version) {
            m_info = &infoOf(EditOperation::Unknown);
        } else {
            m_rest.remove(QLatin1String("op"));
            m_rest.remove(QLatin1String("version"));
        }
        m_edit = usualEdit(m_info->operation);
        m_edit.version = version;
        const QJsonValue name = m_rest.take(QLatin1String("name"));
        if (!name.isString() && !name.isUndefined())
            return failAt("name", ErrorCode::Invalid, RAMURE_NOOP("a text is expected here"));
        m_edit.name = name.toString().toStdString();
        if (auto done = readFlag("enabled", m_edit.enabled); !done)
            return done;
        if (m_isScript && !m_rest.contains(QLatin1String("id")))
            return {};
        return readAddress(m_rest.take(QLatin1String("id")), "id", m_edit.id);
    }
    static Expected<void> readAddress(const QJsonValue& value, const std::string& path, std::uint64_t& into)
    {
        const auto number = branchKeyFromText(value.toString());
        if (!number)
            return failInside(path, number.error());
        into = *number;
        return {};
    }
    Expected<void> readTarget(const char* key, EditTarget& into)
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (value.isUndefined())
            return {};
        if (m_isScript)
            return readAddress(value, key, into.address);
        if (!value.isObject())
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        const QJsonObject object = value.toObject();
        const std::string inside = std::string(key) + '.';
        if (auto done = readAddress(object.value(QLatin1String("id")), inside + "id", into.address); !done)
            return done;
        if (object.contains(QLatin1String("maker")))
            if (auto done = readAddress(object.value(QLatin1String("maker")), inside + "maker", into.maker);
                !done)
                return done;
        auto place = readPlace(object.value(QLatin1String("place")));
        if (!place)
            return failInside(inside + "place", std::move(place.error()));
        into.place = std::move(*place);
        return {};
    }
    Expected<void> readTargets()
    {
        if (auto done = readTarget(m_info->targetKey, m_edit.target); !done)
            return done;
        return m_info->fields & editOther ? readTarget(m_info->otherKey, m_edit.other) : Expected<void>();
    }
    Expected<void> readNumbers()
    {
        for (const EditNumber& number : editNumbers()) {
            const QLatin1String key(number.key);
            if (!(m_info->fields & number.field) || !m_rest.contains(key))
                continue;
            const QJsonValue value = m_rest.take(key);
            if (!value.isDouble())
                return failAt(number.key, ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
            m_edit.*number.member = value.toDouble() * (m_isScript && number.isAngle ? degree : 1.0);
        }
        return {};
    }
    /// Between \p least and \p most numbers.
    static Expected<std::vector<double>> readRow(const QJsonValue& value, const std::string& path,
                                                 qsizetype least, qsizetype most)
    {
        const QJsonArray array = value.toArray();
        std::vector<double> row;
        for (const QJsonValue& number : array)
            row.push_back(number.toDouble(std::nan("")));
        const bool allNumbers = std::none_of(row.begin(), row.end(), [](double x) { return std::isnan(x); });
        if (!value.isArray() || array.size() < least || array.size() > most || !allNumbers)
            return failAt(path, ErrorCode::Invalid, RAMURE_NOOP("%1 numbers are expected here"),
                          {std::to_string(least)});
        return row;
    }
    Expected<void> readVectors()
    {
        // Without a place a brush would act about the origin, where nobody meant it to.
        const bool isBrush = (m_info->fields & editCentre) &&
                             (m_edit.operation != EditOperation::Leaves || m_edit.target.address == 0);
        if (m_isScript && isBrush && !m_rest.contains(QLatin1String("centre")))
            return m_edit.operation == EditOperation::Leaves
                       ? failAt("target", ErrorCode::Invalid, RAMURE_NOOP("the limb is missing"))
                       : failAt("centre", ErrorCode::Invalid, RAMURE_NOOP("%1 numbers are expected here"),
                                {"3"});
        for (const EditVector& vector : editVectors()) {
            const QLatin1String key(vector.key);
            if (!(m_info->fields & vector.field) || !m_rest.contains(key))
                continue;
            const auto row = readRow(m_rest.take(key), vector.key, 3, 3);
            RAMURE_TRY(row);
            m_edit.*vector.member = {(*row)[0], (*row)[1], (*row)[2]};
        }
        return {};
    }
    Expected<void> readFlag(const char* key, bool& into)
    {
        const QJsonValue value = m_rest.take(QLatin1String(key));
        if (!value.isBool() && !value.isUndefined())
            return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("true or false is expected here"));
        into = value.toBool(into);
        return {};
    }
    Expected<void> readFlags()
    {
        for (const EditFlag& flag : editFlags())
            if (m_info->fields & flag.field)
                if (auto done = readFlag(flag.key, m_edit.*flag.member); !done)
                    return done;
        return {};
    }
    /// The numbers of a shape, and the pairs of a profile behind them.
    Expected<void> readRound(const EditShapeInfo& shape, const QJsonValue& value)
    {
        const auto count = static_cast<qsizetype>(shape.numbers);
        const bool hasPairs = shape.kind == EditShapeKind::Profile;
        const std::string path = std::string("shape.") + shape.key;
        const auto row =
            readRow(value, path, count, hasPairs ? count + 2 * qsizetype(mostEditPoints) : count);
        RAMURE_TRY(row);
        if ((row->size() - shape.numbers) % 2 != 0)
            return failAt(path, ErrorCode::Invalid,
                          RAMURE_NOOP("pairs of radius and height are expected here"));
        std::copy_n(row->begin(), shape.numbers, m_edit.shape.numbers.begin());
        for (std::size_t i = shape.numbers; i < row->size(); i += 2)
            m_edit.shape.points.emplace_back((*row)[i], (*row)[i + 1], 0.0);
        return {};
    }
    Expected<void> readMeshShape(const QJsonObject& mesh)
    {
        for (const QJsonValue& point : mesh.value(QLatin1String("points")).toArray()) {
            const auto row = readRow(point, "shape.mesh.points", 3, 3);
            RAMURE_TRY(row);
            m_edit.shape.points.emplace_back((*row)[0], (*row)[1], (*row)[2]);
        }
        for (const QJsonValue& triangle : mesh.value(QLatin1String("triangles")).toArray()) {
            const auto row = readRow(triangle, "shape.mesh.triangles", 3, 3);
            RAMURE_TRY(row);
            std::array<std::uint32_t, 3>& corners = m_edit.shape.triangles.emplace_back();
            for (std::size_t i = 0; i < 3; ++i) {
                if (!((*row)[i] >= 0.0 && (*row)[i] < 4e9))
                    return failAt("shape.mesh.triangles", ErrorCode::Invalid,
                                  RAMURE_NOOP("a number is expected here"));
                corners[i] = static_cast<std::uint32_t>((*row)[i]);
            }
        }
        return {};
    }
    Expected<void> readOrgan()
    {
        if (!(m_info->fields & editOrgan))
            return {};
        const QString key = m_rest.take(QLatin1String("organ")).toString();
        const auto found = std::ranges::find_if(
            editOrgans(), [&key](const EditOrganInfo& info) { return key == QLatin1String(info.key); });
        if (found == editOrgans().end())
            return failAt("organ", ErrorCode::Invalid,
                          RAMURE_NOOP("a leaf, fruit or flower is expected here"));
        m_edit.organ = found->organ;
        return {};
    }
    Expected<void> readShape()
    {
        if (!(m_info->fields & editShape))
            return {};
        const QJsonObject object = m_rest.take(QLatin1String("shape")).toObject();
        for (const EditShapeInfo& shape : editShapes()) {
            if (object.size() != 1 || !object.contains(QLatin1String(shape.key)))
                continue;
            m_edit.shape = {shape.kind, {}, {}, {}};
            const QJsonValue value = object.value(QLatin1String(shape.key));
            return shape.kind == EditShapeKind::Mesh ? readMeshShape(value.toObject())
                                                     : readRound(shape, value);
        }
        return failAt("shape", ErrorCode::Invalid,
                      RAMURE_NOOP("a sphere, box, cone, profile or mesh is expected here"));
    }
    Expected<void> readPoints()
    {
        if (!(m_info->fields & (editPoints | editPath)))
            return {};
        const QJsonArray array = m_rest.take(QLatin1String("points")).toArray();
        for (qsizetype i = 0; i < array.size(); ++i) {
            const auto row = readRow(array[i], "points" + indexPlace(i), 3, 4);
            RAMURE_TRY(row);
            m_edit.points.push_back({{(*row)[0], (*row)[1], (*row)[2]}, row->size() > 3 ? (*row)[3] : 0.0});
        }
        return {};
    }
    /// Behind the ten numbers of a piece.
    static bool areOrgans(const std::vector<double>& n)
    {
        if (n.size() == limbNumbers)
            return true;
        bool good = (n.size() - limbNumbers - 1) % organNumbers == 0 &&
                    (n[limbNumbers] >= 0.0 && n[limbNumbers] <= double(limbSawn | limbBare));
        for (std::size_t i = limbNumbers + 1; good && i < n.size(); i += organNumbers)
            good = n[i] >= 0.0 && n[i] < double(editOrgans().size());
        return good;
    }
    static void takeOrgans(const std::vector<double>& n, LimbPiece& piece)
    {
        const int flags = n.size() > limbNumbers ? static_cast<int>(n[limbNumbers]) : 0;
        piece.sawn = (flags & limbSawn) != 0;
        piece.bare = (flags & limbBare) != 0;
        for (std::size_t i = limbNumbers + 1; i < n.size(); i += organNumbers) {
            const auto vector = [&](std::size_t at) {
                return glm::dvec3(n[i + at], n[i + at + 1], n[i + at + 2]);
            };
            piece.organs.push_back(
                {static_cast<EditOrgan>(n[i]), n[i + 1], n[i + 2], vector(3), vector(6), vector(9)});
        }
    }
    Expected<void> readLimb()
    {
        if (!(m_info->fields & editLimb) || !m_rest.contains(QLatin1String("limb")))
            return {};
        const QJsonArray array = m_rest.take(QLatin1String("limb")).toArray();
        for (qsizetype i = 0; i < array.size(); ++i) {
            const auto row = readRow(array[i], "limb" + indexPlace(i), limbNumbers,
                                     limbNumbers + 1 + organNumbers * qsizetype(mostEditPoints));
            RAMURE_TRY(row);
            const std::vector<double>& n = *row;
            if (!(std::abs(n[0]) < 1e9) || !(std::abs(n[1]) < 1e9) || !areOrgans(n))
                return failAt("limb" + indexPlace(i), ErrorCode::Invalid,
                              RAMURE_NOOP("a number is expected here"));
            LimbPiece piece;
            piece.parent = static_cast<std::int64_t>(n[0]);
            piece.axis = static_cast<std::int64_t>(n[1]);
            piece.p0 = {n[2], n[3], n[4]};
            piece.p1 = {n[5], n[6], n[7]};
            piece.a0 = n[8];
            piece.a1 = n[9];
            takeOrgans(n, piece);
            m_edit.limb.push_back(piece);
        }
        return {};
    }

    Expected<void> readFrozen()
    {
        const QString key = QStringLiteral("tree");
        if (!(m_info->fields & editFrozen) || !m_rest.contains(key))
            return {};
        const QByteArray text = m_rest.take(key).toString().toLatin1();
        std::string bytes = QByteArray::fromBase64(text).toStdString();
        if (auto tree = unpackSkeleton(bytes); !tree)
            return failInside("tree", std::move(tree.error()));
        m_edit.frozen = SharedValue<FrozenTree>(FrozenTree{std::move(bytes)});
        return {};
    }
    Expected<void> readValues()
    {
        if (stepParams(m_edit.operation).empty() || !m_rest.contains(QLatin1String("values")))
            return {};
        const QJsonValue json = m_rest.take(QLatin1String("values"));
        if (!json.isObject())
            return failAt("values", ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        return readStepValues(json.toObject(), m_edit);
    }

    QJsonObject m_rest;
    bool m_isScript;
    const EditOperationInfo* m_info = nullptr;
    TreeEdit m_edit;
};

} // namespace

Expected<void> readStepValues(const QJsonObject& object, TreeEdit& step)
{
    QJsonObject rest = object;
    NodeParams values = *step.values;
    for (const ParamDef* def : stepParams(step.operation)) {
        if (!rest.contains(QLatin1String(def->key)))
            continue;
        const auto value = toParam(*def, rest.take(QLatin1String(def->key)));
        if (!value)
            return failInside(std::string("values.") + def->key, value.error());
        if (auto done = setParam(values, *def, *value); !done)
            return failInside("values", std::move(done.error()));
    }
    if (!rest.isEmpty())
        return failAt("values." + rest.begin().key().toStdString(), ErrorCode::Unknown,
                      RAMURE_NOOP("\"%1\" has no such value"), {infoOf(step.operation).key});
    step.values = StepValues(std::move(values));
    return {};
}

QJsonObject writeShape(const EditShape& shape)
{
    const EditShapeInfo& info = editShapes()[static_cast<std::size_t>(shape.kind)];
    QJsonArray numbers;
    for (std::size_t i = 0; i < info.numbers; ++i)
        numbers.append(shape.numbers[i] + 0.0);
    if (shape.kind == EditShapeKind::Mesh)
        return {{QLatin1String(info.key), writeMeshShape(shape)}};
    if (shape.kind == EditShapeKind::Profile)
        for (const glm::dvec3& point : shape.points) {
            numbers.append(point.x + 0.0);
            numbers.append(point.y + 0.0);
        }
    return {{QLatin1String(info.key), numbers}};
}

QJsonArray writeEdits(const std::vector<TreeEdit>& edits)
{
    QJsonArray array;
    for (const TreeEdit& edit : edits)
        array.append(writeEdit(edit));
    return array;
}

Expected<std::vector<TreeEdit>> readEdits(const QJsonArray& array)
{
    std::vector<TreeEdit> edits;
    for (qsizetype i = 0; i < array.size(); ++i) {
        if (!array[i].isObject())
            return failAt(indexPlace(i), ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        auto edit = EditReader(array[i].toObject(), false).read();
        if (!edit)
            return failInside(indexPlace(i), std::move(edit.error()));
        edits.push_back(std::move(*edit));
    }
    return edits;
}

Expected<ScriptEdits> readScriptEdits(const QJsonObject& line)
{
    QJsonObject rest = line;
    ScriptEdits script;
    const QJsonValue frame = rest.take(QLatin1String("frame"));
    script.inTreeSpace = frame.isUndefined() || frame.toString() == QLatin1String("tree");
    if (!script.inTreeSpace && frame.toString() != QLatin1String("parent"))
        return failAt("frame", ErrorCode::Invalid, RAMURE_NOOP("\"tree\" or \"parent\" is expected here"));
    const QString key = QStringLiteral("target");
    const QJsonArray targets =
        rest.value(key).isArray() ? rest.value(key).toArray() : QJsonArray{rest.value(key)};
    if (targets.isEmpty())
        return failAt("target", ErrorCode::Invalid, RAMURE_NOOP("the limb is missing"));
    for (const QJsonValue& target : targets) {
        if (!target.isUndefined() && !target.isNull())
            rest.insert(key, target);
        auto edit = EditReader(rest, true).read();
        RAMURE_TRY(edit);
        script.edits.push_back(std::move(*edit));
    }
    return script;
}

} // namespace ramure::json
