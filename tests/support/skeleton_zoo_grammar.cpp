#include "tests/support/skeleton_grower.h"

#include <glm/mat3x3.hpp>
#include <string>

namespace ramure::test {
namespace {

/// A random word over `F[]+-/\^_` with balanced brackets, which rewrites to itself with F replaced by another
/// word.
std::string randomWord(Grower& g, int length)
{
    std::string word;
    int open = 0;
    for (int i = 0; i < length; ++i) {
        const char turn = "+-/\\^_"[g.random().below(6)];
        switch (g.random().below(5)) {
        case 0:
            word += '[';
            word += turn;
            ++open;
            break;
        case 1:
            if (open > 0) {
                word += "F]";
                --open;
                break;
            }
            [[fallthrough]];
        case 2:
            word += turn;
            break;
        default:
            word += 'F';
        }
    }
    word += 'F';
    word.append(static_cast<std::size_t>(open), ']');
    return word;
}

/// Turtle of the zoo's own: the zoo must not change with the program's.
void drawWord(Grower& g, const std::string& word, double angle, double decay)
{
    struct State
    {
        glm::dmat3 frame{1.0};
        Index branch = noIndex;
        double radius = 0.1;
    };
    State s;
    std::vector<State> stack;
    const double c = std::cos(angle), sine = std::sin(angle);
    const auto turn = [&](int first, int second, double way) {
        const glm::dvec3 a = s.frame[first], b = s.frame[second];
        s.frame[first] = c * a + way * sine * b;
        s.frame[second] = c * b - way * sine * a;
    };
    for (const char symbol : word)
        switch (symbol) {
        case '[':
            stack.push_back(s);
            break;
        case ']':
            s = stack.back();
            stack.pop_back();
            break;
        case '+':
            turn(1, 2, 1.0);
            break;
        case '-':
            turn(1, 2, -1.0);
            break;
        case '/':
            turn(2, 0, 1.0);
            break;
        case '\\':
            turn(2, 0, -1.0);
            break;
        case '^':
            turn(0, 1, 1.0);
            break;
        case '_':
            turn(0, 1, -1.0);
            break;
        default: {
            if (g.skeleton().size() >= 400)
                return;
            const double next = s.radius * decay;
            s.branch = s.branch == noIndex ? g.root(glm::dvec3(0.0), s.frame[1] * 0.4, s.radius, next)
                                           : g.child(s.branch, s.frame[1] * 0.4, s.radius, next);
            s.radius = next;
        }
        }
}

} // namespace

void growGrammar(Grower& g)
{
    const std::string rule = randomWord(g, g.between(3, 12));
    std::string word = "F";
    for (int i = g.between(1, 4); i > 0 && word.size() < 4000; --i) {
        std::string next;
        for (const char symbol : word)
            next += symbol == 'F' ? rule : std::string(1, symbol);
        word = std::move(next);
    }
    drawWord(g, word, g.chance(0.2) ? std::numbers::pi / 2.0 : g.range(0.1, 1.2), g.range(0.7, 1.0));
}

} // namespace ramure::test
