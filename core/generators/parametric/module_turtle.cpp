#include "core/generators/parametric/module_turtle.h"

#include "core/generators/grammar/branch_keys.h"
#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace ramure {
namespace {

constexpr double farthest = 1e9; ///< m
/// Thinner branches would have no mesh.
constexpr double thinnest = 1e-6; ///< m

struct ModuleState
{
    glm::dvec3 heading{0.0, 1.0, 0.0}, left{-1.0, 0.0, 0.0}, up{0.0, 0.0, 1.0};
    glm::dvec3 position{0.0};
    double radius = 0.0;
    double radiusBefore = -1.0; ///< at the end of the piece that the next one continues; below 0: none
    Index branch = noIndex;     ///< the last one on the way
    bool isApart = true;        ///< the next branch does not begin where that one ends
    Index turns = 0;            ///< by chance: since that branch
};

/// Rotates \p a towards \p b.
void turn(glm::dvec3& a, glm::dvec3& b, const maths::SinCos& by)
{
    const glm::dvec3 before = a;
    a = by.cos * a + by.sin * b;
    b = by.cos * b - by.sin * before;
}

glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, const maths::SinCos& by)
{
    return by.cos * v + by.sin * glm::cross(axis, v) + (1.0 - by.cos) * glm::dot(axis, v) * axis;
}

/// Angles come again and again: most of a tree's are a few constants.
class Turns
{
public:
    maths::SinCos of(double rad)
    {
        const auto bits = std::bit_cast<std::uint64_t>(rad);
        Known& known = m_known[mixBits(bits) % m_known.size()];
        if (!known.isSet || std::bit_cast<std::uint64_t>(known.rad) != bits)
            known = {rad, maths::sincos(rad), true};
        return known.by;
    }

private:
    struct Known
    {
        double rad = 0.0;
        maths::SinCos by{};
        bool isSet = false;
    };
    std::array<Known, 64> m_known;
};

class ModuleTurtle
{
public:
    ModuleTurtle(const ModuleWord& word, const TurtleParams& params, const TurtleChance& chance,
                 std::size_t branches)
        : m_word(word)
        , m_params(params)
        , m_chance(chance)
    {
        m_levels.back().radius = params.alpha;
        m_children.assign(branches, 0);
        m_skeleton.resize(branches);
    }

    /// Reads up to \p to.
    Expected<void> read(std::size_t to)
    {
        for (; m_at < to; ++m_at)
            if (const char* problem = step(m_word.modules[m_at]))
                return failAt(m_word.sources[m_word.modules[m_at].source].place, ErrorCode::Invalid, problem,
                              {m_word.text(m_word.modules[m_at])});
        return {};
    }

    Skeleton finish()
    {
        m_skeleton.resize(m_count); // less where a branch was cut, or had no length
        return std::move(m_skeleton);
    }

private:
    [[nodiscard]] double numberOf(const Module& module, double otherwise) const
    {
        return m_word.numbersOf(module) > 0 ? m_word.numbers[module.firstNumber] : otherwise;
    }

    /// What is wrong with the module, or null.
    const char* step(const Module& module)
    {
        ModuleState& state = m_levels.back();
        switch (module.name) {
        case 'F':
        case 'f':
            return move(state, numberOf(module, m_params.alpha), module.name == 'F');
        case '!':
            return widen(state, module);
        case '+':
            turn(state.heading, state.left, by(state, module, 1.0));
            break;
        case '-':
            turn(state.heading, state.left, by(state, module, -1.0));
            break;
        case '&':
            turn(state.up, state.heading, by(state, module, 1.0));
            break;
        case '^':
            turn(state.up, state.heading, by(state, module, -1.0));
            break;
        case '\\':
            turn(state.left, state.up, by(state, module, 1.0));
            break;
        case '/':
            turn(state.left, state.up, by(state, module, -1.0));
            break;
        case '|':
            state.heading = -state.heading;
            state.left = -state.left;
            break;
        case '$':
            level(state);
            break;
        case '[':
            if (m_levels.size() > maxBracketDepth)
                return RAMURE_NOOP("brackets are nested too deep here");
            m_levels.push_back(state);
            m_levels.back().radiusBefore = -1.0;
            break;
        case ']':
            m_levels.pop_back();
            break;
        case '%':
            skipBranch();
            break;
        case '~':
            return putOrgan(state, module);
        default:
            break;
        }
        return nullptr;
    }

    /// Up to the bracket that closes the branch, which is read next.
    void skipBranch()
    {
        for (int depth = 0; m_at + 1 < m_word.modules.size(); ++m_at) {
            const char name = m_word.modules[m_at + 1].name;
            depth += (name == '[') - (name == ']');
            if (depth < 0)
                return;
        }
    }

    maths::SinCos by(ModuleState& state, const Module& module, double sign)
    {
        double rad = m_word.numbersOf(module) > 0
                         ? std::fmod(m_word.numbers[module.firstNumber], 360.0) * oneDegree
                         : m_params.theta;
        if (m_chance.variation.angle != 0.0) {
            Random random(m_chance.seed, RandomStream::BranchTurn, nextKey(state) + state.turns++);
            rad *= 1.0 + m_chance.variation.angle * random.range(-1.0, 1.0);
        }
        return m_turns.of(sign * rad);
    }

    static void level(ModuleState& state)
    {
        const glm::dvec3 across = glm::cross(glm::dvec3(0.0, 1.0, 0.0), state.heading);
        const double length = glm::length(across);
        if (length < 1e-9) // straight up or down: every roll is level
            return;
        state.left = across / length;
        state.up = glm::cross(state.heading, state.left);
    }

    const char* widen(ModuleState& state, const Module& module)
    {
        const double diameter = numberOf(module, 2.0 * state.radius * m_params.decay);
        if (diameter < 0.0 || diameter > farthest)
            return RAMURE_NOOP("%1 asks for a diameter below 0, or beyond all measure");
        state.radius = std::max(0.5 * diameter, thinnest);
        return nullptr;
    }

    [[nodiscard]] std::uint64_t nextKey(const ModuleState& state) const
    {
        const bool isRoot = state.branch == noIndex;
        return branchKeyBelow(isRoot ? rootBranchKey : m_skeleton.key[state.branch],
                              isRoot ? m_roots : m_children[state.branch]);
    }

    const char* move(ModuleState& state, double length, bool draws)
    {
        if (length < 0.0)
            return RAMURE_NOOP("%1 asks for a length below 0");
        const std::uint64_t key = nextKey(state);
        if (m_chance.variation.length != 0.0) {
            Random random(m_chance.seed, RandomStream::BranchShape, key);
            length *= 1.0 + m_chance.variation.length * random.range(-1.0, 1.0);
        }
        const glm::dvec3 from = state.position;
        state.position += length * state.heading;
        if (!(glm::length(state.position) <= farthest))
            return RAMURE_NOOP("at %1 the tree is larger than 10^6 km");
        state.isApart = state.isApart || (!draws && length > 0.0);
        if (draws && length > 0.0)
            draw(state, from, key);
        if (draws && m_params.elasticity != 0.0)
            bend(state);
        return nullptr;
    }

    void draw(ModuleState& state, const glm::dvec3& from, std::uint64_t key)
    {
        ++(state.branch == noIndex ? m_roots : m_children[state.branch]);
        const Index i = m_count++;
        m_skeleton.parent[i] = state.isApart ? noIndex : state.branch;
        m_skeleton.p0[i] = from;
        m_skeleton.p1[i] = state.position;
        m_skeleton.a0[i] = state.isApart || state.radiusBefore < 0.0 ? state.radius : state.radiusBefore;
        m_skeleton.a1[i] = state.radius;
        m_skeleton.level[i] = static_cast<Index>(m_levels.size() - 1);
        m_skeleton.key[i] = key;
        m_skeleton.source[i] = i;
        state.radiusBefore = state.radius;
        state.branch = i;
        state.isApart = false;
        state.turns = 0;
    }

    const char* putOrgan(const ModuleState& state, const Module& module)
    {
        const std::optional<OrganKind> kind = m_word.sources[module.source].organ;
        if (!kind)
            return nullptr;
        const double size = numberOf(module, -1.0);
        if (m_word.numbersOf(module) > 0 && !(size >= 0.0 && size <= farthest))
            return RAMURE_NOOP("%1 asks for a size below 0, or beyond all measure");
        if (state.branch == noIndex)
            return RAMURE_NOOP("%1 has no branch before it that could carry it");
        const glm::dvec3 end = m_skeleton.p1[state.branch];
        m_skeleton.organs.push_back({state.branch, *kind, 1.0, state.position - end,
                                     glm::normalize(end - m_skeleton.p0[state.branch]), state.heading,
                                     state.up, size});
        return nullptr;
    }

    void bend(ModuleState& state)
    {
        const glm::dvec3 across = glm::cross(state.heading, m_params.tropism);
        const double length = glm::length(across);
        if (length < 1e-12)
            return;
        const maths::SinCos by = maths::sincos(m_params.elasticity * length);
        const glm::dvec3 axis = across / length;
        for (glm::dvec3* v : {&state.heading, &state.left, &state.up})
            *v = rotated(*v, axis, by);
    }

    const ModuleWord& m_word;
    const TurtleParams& m_params;
    TurtleChance m_chance;
    Turns m_turns;
    std::size_t m_at = 0;
    std::vector<ModuleState> m_levels{ModuleState()}; ///< the last one is where the turtle is
    std::vector<Index> m_children;                    ///< children that each branch has so far
    Index m_roots = 0, m_count = 0;
    Skeleton m_skeleton;
};

} // namespace

Expected<Skeleton> runModuleTurtle(const ModuleWord& word, const TurtleParams& params,
                                   const TurtleChance& chance, const Progress& progress)
{
    const auto branches = static_cast<std::size_t>(std::ranges::count(word.modules, 'F', &Module::name));
    ModuleTurtle turtle(word, params, chance, branches);
    constexpr std::size_t stride = std::size_t(1) << 18;
    for (std::size_t from = 0; from < word.modules.size(); from += stride) {
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        RAMURE_TRY(turtle.read(std::min(from + stride, word.modules.size())));
        progress.report(static_cast<double>(from) / static_cast<double>(word.modules.size()));
    }
    Skeleton skeleton = turtle.finish();
    if (!skeleton.empty())
        return skeleton;
    Error none;
    none.text = RAMURE_NOOP("the grammar draws no branch at all");
    none.path = "grammar.axiom";
    return fail(std::move(none));
}

} // namespace ramure
