#include "core/rig/physics/physics_script.h"

#include "core/math/stage_hash.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// The last change that counts before \p step, as its position + 1; 0 = none.
template <class List> std::size_t countBefore(const List& list, std::int64_t step)
{
    const auto end =
        std::ranges::lower_bound(list, step, {}, [](const auto& change) { return change.first; });
    return static_cast<std::size_t>(end - list.begin());
}

void add(StageHash& hash, const PhysicsParams& params)
{
    visitFields(params, [&](const auto& field) {
        if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(field)>>)
            hash.add(static_cast<int>(field));
        else
            hash.add(field);
    });
}

void add(StageHash& hash, const std::optional<Pull>& pull)
{
    hash.add(pull.has_value());
    if (pull)
        hash.add(pull->branch)
            .add(pull->along)
            .add(pull->target.x)
            .add(pull->target.y)
            .add(pull->target.z)
            .add(pull->strength);
}

void add(StageHash& hash, Index apple)
{
    hash.add(apple);
}

template <class List> void hashFrom(const List& list, std::vector<std::uint64_t>& keys, std::size_t from)
{
    keys.resize(list.size());
    for (std::size_t i = from; i < list.size(); ++i) {
        StageHash hash(i == 0 ? 0 : keys[i - 1]);
        hash.add(list[i].first);
        add(hash, list[i].second);
        keys[i] = hash.value();
    }
}

std::uint64_t keyBefore(const std::vector<std::uint64_t>& keys, std::size_t count)
{
    return count == 0 ? 0 : keys[count - 1];
}

} // namespace

void PhysicsScript::setParams(const PhysicsParams& params, std::int64_t from)
{
    m_params.resize(countBefore(m_params, from), {0, params});
    if (m_params.empty() || m_params.back().second != params)
        m_params.emplace_back(from, params);
    hashFrom(m_params, m_paramKeys, m_params.size() - 1);
}

void PhysicsScript::setPull(const std::optional<Pull>& pull, std::int64_t from)
{
    m_pulls.resize(countBefore(m_pulls, from));
    const std::optional<Pull> before = m_pulls.empty() ? std::nullopt : m_pulls.back().second;
    if (before != pull)
        m_pulls.emplace_back(from, pull);
    hashFrom(m_pulls, m_pullKeys, m_pulls.empty() ? 0 : m_pulls.size() - 1);
}

void PhysicsScript::shakeOff(Index apple, std::int64_t at)
{
    const auto same = std::ranges::find(m_apples, apple, &AppleChange::second);
    if (same != m_apples.end()) {
        if (same->first <= at)
            return;
        m_apples.erase(same);
    }
    const auto place = std::ranges::upper_bound(m_apples, at, {}, &AppleChange::first);
    m_apples.insert(place, {at, apple});
    hashFrom(m_apples, m_appleKeys, 0);
}

void PhysicsScript::clear()
{
    *this = PhysicsScript(m_params.front().second);
}

const PhysicsParams& PhysicsScript::paramsAt(std::int64_t step) const
{
    return m_params[std::max<std::size_t>(countBefore(m_params, step + 1), 1) - 1].second;
}

const std::optional<Pull>& PhysicsScript::pullAt(std::int64_t step) const
{
    static const std::optional<Pull> none;
    const std::size_t count = countBefore(m_pulls, step + 1);
    return count == 0 ? none : m_pulls[count - 1].second;
}

std::vector<Index> PhysicsScript::applesAt(std::int64_t step) const
{
    std::vector<Index> out;
    for (std::size_t i = countBefore(m_apples, step); i < m_apples.size() && m_apples[i].first == step; ++i)
        out.push_back(m_apples[i].second);
    return out;
}

std::uint64_t PhysicsScript::keyAt(std::int64_t step) const
{
    return StageHash(keyBefore(m_paramKeys, countBefore(m_params, step)))
        .add(keyBefore(m_pullKeys, countBefore(m_pulls, step)))
        .add(keyBefore(m_appleKeys, countBefore(m_apples, step)))
        .value();
}

double PhysicsScript::timeAt(std::int64_t step) const
{
    double start = 0.0;
    std::int64_t first = 0;
    for (std::size_t i = 0;; ++i) {
        const double length = m_params[i].second.stepSeconds;
        // Stretches of one length are one: t = k dt holds across changes of anything else.
        while (i + 1 < m_params.size() && m_params[i + 1].second.stepSeconds == length)
            ++i;
        if (i + 1 == m_params.size() || m_params[i + 1].first >= step)
            return start + static_cast<double>(step - first) * length;
        start += static_cast<double>(m_params[i + 1].first - first) * length;
        first = m_params[i + 1].first;
    }
}

std::int64_t PhysicsScript::stepAt(double timeSeconds) const
{
    double start = 0.0;
    std::int64_t first = 0;
    for (std::size_t i = 0;; ++i) {
        const double length = m_params[i].second.stepSeconds;
        while (i + 1 < m_params.size() && m_params[i + 1].second.stepSeconds == length)
            ++i;
        // Far times stay below what a whole number can hold.
        const double steps = std::clamp(std::round((timeSeconds - start) / length), 0.0, 1e15);
        if (i + 1 == m_params.size())
            return first + static_cast<std::int64_t>(steps);
        const double end = start + static_cast<double>(m_params[i + 1].first - first) * length;
        if (timeSeconds <= end)
            return first + static_cast<std::int64_t>(steps);
        start = end;
        first = m_params[i + 1].first;
    }
}

} // namespace ramure
