/// \file
/// The tree while it grows: what growHistory() does in a year, step by step. Nobody else includes this.
#pragma once

#include "core/generators/growth/free_space.h"
#include "core/generators/growth/growth_history.h"
#include "core/generators/growth/neighbours.h"
#include "core/generators/growth/shadow_grid.h"
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <unordered_set>

namespace ramure {
struct Skeleton;
struct TreeAxes;
} // namespace ramure

namespace ramure::growth {

/// The numbers of the model that follow from what an artist says, for one year.
struct YearFactors
{
    int year = 0;
    double shade = 0.1;       ///< a of the shadows
    double trunkLambda = 0.5; ///< Borchert and Honda's, of axes of order 0
    double limbLambda = 0.5;
    double vigourCap = 1.0;               ///< metamers that the roots pay for
    double longest = 1.0;                 ///< metamers of the longest shoot
    std::array<double, 16> sideLongest{}; ///< the same, by the order of its axis
    double claim = 0.0;                   ///< metamers that a leader takes before all others
};

/// What a site does to a tree, in all years alike: level vectors, shorter than 1.
struct Site
{
    glm::dvec3 wind{0.0};     ///< to leeward
    glm::dvec3 light{0.0};    ///< to the open side
    glm::dvec3 downhill{0.0}; ///< unit
    double grade = 0.0;       ///< m that the ground falls in a metre

    explicit Site(const GrowthParams& params);
    /// m, of a place above the ground.
    [[nodiscard]] double above(const glm::dvec3& at) const { return at.y + grade * glm::dot(at, downhill); }
    /// How far a place is from the middle of the crown: winds and light from one side move and squeeze it.
    /// \param up its height as a share of the tree's \param wide m, of the crown
    [[nodiscard]] double aside(const glm::dvec3& at, double up, double wide) const;
};

/// The share of the sky that no solid of the scene hides, by nine directions. \pre params.space.space()
/// \param towards becomes the mean of those that are open, level
double openSky(const GrowthParams& params, const glm::dvec3& at, glm::dvec3& towards);

/// Rotation by what wood has bent down since its birth. \param direction unit, at birth.
glm::dquat bendOf(const glm::dvec3& direction, double angle);

class GrowingTree
{
public:
    GrowingTree(GrowthHistory& history, std::uint64_t seed);

    /// Begins with a tree that stands already, as the first year: before anything else.
    void stand(const Skeleton& tree, const TreeAxes& axes);
    /// The room that the tree fills, where it looks for it. Errors: those of GrowthSpace.
    Expected<void> findRoom(const Progress& progress);
    /// False: the shadows would need more voxels than there may be.
    bool gatherLight(const YearFactors& factors);
    void shareVigour(const YearFactors& factors);
    void growShoots(const YearFactors& factors);
    /// Marks what cuts of \p age take for the shedding. \return whether there is any
    bool cut(int age);
    void shed(const YearFactors& factors);
    /// From now on all but what stands where something was cut shares the life of this tree.
    void follow(const GrowthHistory& uncut);
    void thicken(const YearFactors& factors);
    void record();
    [[nodiscard]] bool empty() const { return m_nodes.empty(); }
    /// All that is left goes, at \p age.
    void die(int age);
    [[nodiscard]] const GrowthYear& seen() const { return m_year; }

private:
    struct AxisState
    {
        Index base = noIndex, tip = noIndex; ///< metamers
        std::uint16_t nodes = 0;             ///< grown so far
        std::uint8_t dark = 0;               ///< years in the shade, of all it carries
        std::uint8_t tipDark = 0;            ///< years that its end could not grow
        std::uint8_t weak = 0;               ///< years that it made short shoots only
        float foot = 0.0f;                   ///< m, height at which its limb leaves the trunk
        bool tipLives = true;
        bool upright = false; ///< begins the tree anew
    };
    /// A living metamer. Nodes lie in the order of birth, side by side: the indices of a year are theirs.
    struct Node
    {
        Index metamer = noIndex; ///< of the history
        Index parent = noIndex;  ///< node
        Index axis = 0;
        std::uint16_t birth = 0;
        std::uint8_t order = 0;
        bool tip = false; ///< the living end of its axis
        std::uint64_t address = 0;
        glm::vec3 side{0.0f};               ///< unit, at birth: where the first bud looks
        float bend = 0.0f;                  ///< rad
        float pipes = 0.0f, lost = 0.0f;    ///< tips it carries, and those of shed branches
        float moment = 0.0f;                ///< N m, of its load a year ago
        float light = 0.0f;                 ///< at its buds
        float outline = 1.0f;               ///< of the crown there
        float sky = 1.0f;                   ///< share of it that no solid hides
        std::uint8_t buds = 0, dormant = 0; ///< alive; asleep
        std::uint8_t budYears = 0, bare = 0;
        std::uint8_t rank = 0, of = 1; ///< within its year's shoot
        bool cut = false;              ///< somebody cuts it below
        bool woken = false;            ///< its dormant buds shoot next year
        bool dead = false;             ///< bare with all that it carries, it breaks off in time
        Index twin = noIndex;          ///< metamer of the tree without cuts whose life it shares
    };
    /// How a node stands: apart from it, as most of a year asks for one of the two.
    struct Pose
    {
        glm::dvec3 at{0.0};        ///< its upper end
        glm::dvec3 direction{0.0}; ///< as it is bent now
        glm::dquat frame{1.0, 0.0, 0.0, 0.0};
        glm::vec3 rest{0.0f}; ///< direction, as the history keeps it
        float length = 0.0f;
    };
    /// What flows, for one year.
    struct Flow
    {
        double main = 0.0, side = 0.0, ownSide = 0.0; ///< light above: along the axis, aside, of own buds
        double vigour = 0.0;
        double tipVigour = 0.0, sideVigour = 0.0; ///< for its own buds
        float light = 0.0f;                       ///< of all that is above
        Index active = 0;                         ///< nodes above with living buds
    };
    /// What a node carries.
    struct Load
    {
        glm::dvec4 weight{0.0}; ///< kg, and kg m in x, y, z
        double pipes = 0.0;
    };
    /// A bud, or all buds of a node, or a limb, with the place of its vigour.
    struct RankedLight
    {
        double light;
        Index node;
        double* vigour;
    };
    struct ShootStart
    {
        Index from = noIndex; ///< metamer; noIndex: the ground
        Index axis = 0;
        glm::dvec3 at{0.0}, direction{0.0};
        glm::dvec3 side{0.0};
        bool isNew = false;
        Index twin = noIndex; ///< of the first metamer
    };

    Index standPiece(const Skeleton& tree, Index piece, Index axis, Index below);
    void giveBuds();
    void settle();
    [[nodiscard]] Index axisOf(std::uint64_t address) const;
    bool cutAxis(const GrowthCut& cut, bool& isCut);
    bool prune(const GrowthCut& cut, bool& isCut);
    void drawProfile();
    [[nodiscard]] double outline(const glm::dvec3& at) const;
    [[nodiscard]] double corner(int x, int y, int z) const; ///< chance there, for the outline
    [[nodiscard]] double envelope(const glm::dvec3& at, float outline, unsigned order, double foot) const;
    [[nodiscard]] double chance(std::uint64_t address, std::uint64_t purpose) const; ///< 0 .. 1
    [[nodiscard]] double budWeight(Index metamer) const;
    [[nodiscard]] Index living() const { return static_cast<Index>(m_nodes.size()); }
    [[nodiscard]] double lives(const Pose& pose) const;
    void lightOf(Index metamer, const YearFactors& factors);
    void sumLight();
    double claim(const YearFactors& factors);
    [[nodiscard]] double lambdaOf(Index axis, const YearFactors& factors) const;
    void shareAtForks(const YearFactors& factors);
    void shareByRank();
    void rank(std::vector<RankedLight>& ranked, double vigour) const;
    void age(Index metamer);
    void growFrom(Index metamer, const YearFactors& factors);
    void growTip(Index metamer, double vigour, const YearFactors& factors);
    void growSide(Index metamer, double vigour, const YearFactors& factors);
    void wake(Index below);
    void noteTwins();
    void opened(const glm::dvec3& at);
    [[nodiscard]] std::uint64_t cellOf(const glm::dvec3& at) const;
    void growAsTwin(Index node, const YearFactors& factors);
    [[nodiscard]] Index twinOnAxis(Index twin, int year) const;
    void sprout(Index metamer, const YearFactors& factors);
    void reiterate(Index metamer, const YearFactors& factors);
    Index newAxis(Index parent, unsigned bud, unsigned order, bool upright, int year);
    [[nodiscard]] int shootLength(double vigour, unsigned order, double& stretch,
                                  const YearFactors& factors) const;
    glm::dvec3 lightAt(const ShootStart& start, const YearFactors& factors);
    void grow(ShootStart start, int nodes, double length, const YearFactors& factors);
    glm::dvec3 turned(const ShootStart& start, const glm::dvec3& light, double strength,
                      std::uint64_t address) const;
    [[nodiscard]] glm::dvec3 blown(const glm::dvec3& at) const;
    std::uint8_t budsOf(unsigned order, int rank, int nodes, std::uint64_t address) const;
    Index addMetamer(const ShootStart& start, const glm::dvec3& direction, double length, int year);
    double thicknessOf(float pipes);
    [[nodiscard]] int bareYears(const Node& node);
    void wither(Node& node, int age);
    enum class Fate : std::uint8_t { Lives, Dies, Falls };
    void measureHeights();
    Fate fateOf(Index node, Index parent, double least, int age);
    void bend(Index node, double girth, const YearFactors& factors);
    void place();
    void remove(const Node& base, Node& below);

    GrowthHistory& m_history;
    const GrowthParams& m_params;
    Site m_site;
    Neighbours m_neighbours;
    std::uint64_t m_seed;
    std::uint64_t m_salt = 0; ///< of the addresses on axes that have grown before
    void lookForRoom();
    ShadowGrid m_shadows;
    std::optional<FreeSpace> m_room;
    static constexpr double occupied = 2.0; ///< internodes around wood
    bool m_wasCut = false;                  ///< this year
    std::vector<glm::dvec3> m_towards;      ///< by metamer: unit, where it sees room; 0: nowhere
    std::vector<AxisState> m_axes;
    std::vector<Node> m_nodes;
    std::vector<Pose> m_poses;  ///< of the nodes
    std::vector<Index> m_place; ///< by node: where it lies after the shedding, or noIndex
    std::vector<Flow> m_flow;
    std::vector<Index> m_active;    ///< those with buds that can grow
    std::vector<float> m_thickness; ///< by packed pipes; 0: not known yet
    std::vector<Load> m_load;
    std::vector<double> m_highest; ///< m, see measureHeights
    const GrowthHistory* m_uncut = nullptr;
    std::vector<Index> m_firstTwin, m_nextTwin; ///< children of its metamers, by parent and by child
    std::unordered_set<std::uint64_t> m_opened; ///< cells where something was cut
    std::array<double, 242> m_profile{};        ///< of the crown
    static constexpr int cornersWide = 12, cornersHigh = 8;
    std::vector<double> m_corners; ///< near the tree; others are drawn when asked for
    double m_top = 0.0;
    /// Of the turn from bud to bud. Trunks of species with buds in two rows turn as they grow: a spiral.
    [[nodiscard]] double nextSine(unsigned order) const { return m_turnSine[order > 0 ? 1 : 0]; }
    [[nodiscard]] double nextCosine(unsigned order) const { return m_turnCosine[order > 0 ? 1 : 0]; }
    std::array<double, 2> m_turnSine{}, m_turnCosine{}; ///< of trunks, of other axes
    GrowthYear m_year;
};

} // namespace ramure::growth
