#include "core/qt/document/project/project_arm.h"

#include "core/qt/document/project/project_json.h"
#include "core/rig/arm/arm_chain.h"

namespace ramure::json {
namespace {

/// The numbers of an angle by their names in files.
struct AngleNumber
{
    const char* key;
    double ArmAngle::*member;
};
constexpr AngleNumber angleNumbers[] = {
    {"angle", &ArmAngle::angleRad},
    {"min", &ArmAngle::minRad},
    {"max", &ArmAngle::maxRad},
    {"mostSpeed", &ArmAngle::mostSpeed},
};

QJsonObject writeAngle(const ArmAngle& angle)
{
    QJsonObject object;
    for (const AngleNumber& number : angleNumbers)
        if (angle.*number.member != ArmAngle().*number.member)
            object.insert(QLatin1String(number.key), angle.*number.member);
    if (angle.limited)
        object.insert(QStringLiteral("limited"), true);
    return object;
}

/// Takes a number out of \p object.
Expected<void> takeNumber(QJsonObject& object, const char* key, const std::string& place, double& number)
{
    const QJsonValue value = object.take(QLatin1String(key));
    if (value.isUndefined())
        return {};
    if (!value.isDouble())
        return failAt(place + "." + key, ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
    number = value.toDouble();
    return {};
}

Expected<void> nothingLeft(const QJsonObject& object, const std::string& place)
{
    if (object.isEmpty())
        return {};
    return failAt(place + "." + object.begin().key().toStdString(), ErrorCode::Invalid,
                  RAMURE_NOOP("nothing of this name is expected here"));
}

Expected<void> readAngle(const QJsonValue& value, const std::string& place, ArmAngle& angle)
{
    if (value.isUndefined())
        return {};
    if (!value.isObject())
        return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
    QJsonObject object = value.toObject();
    for (const AngleNumber& number : angleNumbers)
        if (auto done = takeNumber(object, number.key, place, angle.*number.member); !done)
            return done;
    const QJsonValue limited = object.take(QLatin1String("limited"));
    if (!limited.isBool() && !limited.isUndefined())
        return failAt(place + ".limited", ErrorCode::Invalid, RAMURE_NOOP("true or false is expected here"));
    angle.limited = limited.toBool();
    return nothingLeft(object, place);
}

Expected<ArmJoint> readJoint(const QJsonValue& value, const std::string& place)
{
    if (!value.isObject())
        return failAt(place, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
    QJsonObject object = value.toObject();
    ArmJoint joint;
    RAMURE_TRY(takeNumber(object, "length", place, joint.length));
    RAMURE_TRY(readAngle(object.take(QLatin1String("phi")), place + ".phi", joint.phi));
    RAMURE_TRY(readAngle(object.take(QLatin1String("theta")), place + ".theta", joint.theta));
    RAMURE_TRY(nothingLeft(object, place));
    return joint;
}

} // namespace

QJsonArray writeJoints(const std::vector<ArmJoint>& joints)
{
    QJsonArray array;
    for (const ArmJoint& joint : joints) {
        QJsonObject object;
        if (joint.length != ArmJoint().length)
            object.insert(QStringLiteral("length"), joint.length);
        if (const QJsonObject phi = writeAngle(joint.phi); !phi.isEmpty())
            object.insert(QStringLiteral("phi"), phi);
        if (const QJsonObject theta = writeAngle(joint.theta); !theta.isEmpty())
            object.insert(QStringLiteral("theta"), theta);
        array.append(object);
    }
    return array;
}

Expected<std::vector<ArmJoint>> readJoints(const QJsonValue& value)
{
    if (!value.isArray())
        return failAt("joints", ErrorCode::Invalid, RAMURE_NOOP("an array is expected here"));
    std::vector<ArmJoint> joints;
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size() && i <= qsizetype(mostArmJoints); ++i) {
        auto joint = readJoint(array[i], "joints" + indexPlace(i));
        RAMURE_TRY(joint);
        joints.push_back(*joint);
    }
    RAMURE_TRY(checkArm(joints));
    return joints;
}

} // namespace ramure::json
