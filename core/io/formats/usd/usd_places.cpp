#include "core/io/formats/usd/usd_places.h"

#include "core/io/formats/usd/usd_shape.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <optional>

namespace ramure::usd {
namespace {

constexpr std::size_t mostCopies = 10'000'000;
constexpr double degree = std::numbers::pi / 180.0;

glm::dmat4 turnAbout(int axis, double degrees)
{
    glm::dvec3 about(0.0);
    about[axis] = 1.0;
    return glm::mat4_cast(maths::angleAxis(degree * degrees, about));
}

glm::dquat unit(double w, double x, double y, double z)
{
    const glm::dquat q(w, x, y, z);
    return glm::dot(q, q) > 0.0 ? glm::normalize(q) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

/// \param kind "translate", "rotateXYZ" ...
std::optional<glm::dmat4> operation(const std::string& kind, const std::vector<double>& numbers)
{
    const auto at = [&](std::size_t i) { return i < numbers.size() ? numbers[i] : 0.0; };
    const glm::dvec3 three(at(0), at(1), at(2));
    if (kind == "transform" && numbers.size() == 16)
        return glm::make_mat4(numbers.data());
    if (kind == "translate" && numbers.size() == 3)
        return glm::translate(glm::dmat4(1.0), three);
    if (kind == "scale" && numbers.size() == 3)
        return glm::scale(glm::dmat4(1.0), three);
    if (kind == "orient" && numbers.size() == 4)
        return glm::mat4_cast(unit(at(0), at(1), at(2), at(3)));
    if (!kind.starts_with("rotate") || numbers.size() + 6 < kind.size())
        return std::nullopt;
    glm::dmat4 out(1.0);
    for (std::size_t i = 6; i < kind.size(); ++i) { // the first named axis turns first
        const int axis = kind[i] - 'X';
        if (axis < 0 || axis > 2)
            return std::nullopt;
        out = turnAbout(axis, kind.size() == 7 ? at(0) : three[axis]) * out;
    }
    return out;
}

} // namespace

Expected<glm::dmat4> placeOf(const Prim& prim, std::vector<std::string>& notes)
{
    glm::dmat4 out(1.0);
    const Attribute* order = prim.attribute("xformOpOrder");
    if (!order || !order->get())
        return out;
    for (std::string name : order->get()->texts) {
        const bool isInverse = name.starts_with("!invert!");
        if (isInverse)
            name.erase(0, 8);
        const Attribute* attribute = prim.attribute(name);
        if (name == "!resetXformStack!" || !attribute || !attribute->get()) {
            notes.push_back(prim.name + ": " + name);
            continue;
        }
        std::string kind = name.substr(std::min<std::size_t>(name.size(), std::string("xformOp:").size()));
        kind.resize(std::min(kind.find(':'), kind.size()));
        const auto numbers = numbersOf(prim, name, attribute->components);
        RAMURE_TRY(numbers);
        const auto one = operation(kind, *numbers);
        if (!one)
            return wrongAttribute(prim, name, RAMURE_NOOP("an unknown operation, or of another type"));
        if (isInverse && glm::determinant(*one) == 0.0)
            return wrongAttribute(prim, name, RAMURE_NOOP("a place that cannot be inverted"));
        out = out * (isInverse ? glm::inverse(*one) : *one);
    }
    return out;
}

Expected<std::vector<Copy>> copiesOf(const Prim& prim)
{
    const auto targets = prim.relations.find("prototypes");
    const std::size_t prototypes = targets == prim.relations.end() ? 0 : targets->second.size();
    const auto which = indicesOf(prim, "protoIndices", prototypes);
    RAMURE_TRY(which);
    const auto places = numbersOf(prim, "positions", 3), sizes = numbersOf(prim, "scales", 3);
    RAMURE_TRY(places);
    RAMURE_TRY(sizes);
    const char* turning = prim.attribute("orientations") ? "orientations" : "orientationsf";
    const auto turns = numbersOf(prim, turning, 4);
    RAMURE_TRY(turns);
    const std::size_t count = which->size();
    if (count > mostCopies)
        return fail(ErrorCode::Limit, RAMURE_NOOP("more than %1 copies"), {std::to_string(mostCopies)});
    const std::tuple<const char*, std::size_t, bool> lists[] = {
        {"positions", places->size() / 3, true},
        {"scales", sizes->size() / 3, !sizes->empty()},
        {turning, turns->size() / 4, !turns->empty()}};
    for (const auto& [name, has, isThere] : lists)
        if (isThere && has != count)
            return wrongAttribute(prim, name, RAMURE_NOOP("%1 values where there have to be %2"),
                                  {std::to_string(has), std::to_string(count)});
    std::vector<Copy> out;
    for (std::size_t i = 0; i < count; ++i) {
        glm::dmat4 place = glm::translate(glm::dmat4(1.0), glm::make_vec3(&(*places)[3 * i]));
        if (!turns->empty()) {
            const double* q = &(*turns)[4 * i];
            place = place * glm::mat4_cast(unit(q[0], q[1], q[2], q[3]));
        }
        if (!sizes->empty())
            place = glm::scale(place, glm::make_vec3(&(*sizes)[3 * i]));
        out.push_back({(*which)[i], place});
    }
    return out;
}

} // namespace ramure::usd
