/// \file
/// How a tree is cut out of its history: what stands, where and how thick. Internal to grown_skeleton.cpp and
/// whole_life.cpp.
#pragma once

#include "core/generators/growth/growth_history.h"
#include "core/skeleton/skeleton.h"

namespace ramure::growth {

class AgeCutter
{
public:
    struct Piece
    {
        Index metamer;
        Index parent;         ///< piece
        Index next = noIndex; ///< piece that goes on
        double radius;
        double side = 0.0;  ///< radius of the thickest that starts at its end aside
        double sides = 0.0; ///< m2, the squares of the radii of all of them
        double reach = 0.0; ///< m to the farthest tip, itself counted
        glm::dvec3 at{0.0};
        Index heir = noIndex;  ///< piece that goes on, or where the axis ends the thickest that starts there
        bool isBroken = false; ///< dead, its axis went on
    };

    /// What lives at an age.
    AgeCutter(const GrowthHistory& history, double age);
    /// All that ever lived on some axes, each metamer as it was in its last year. What no longer lives, or
    /// lies in wood that has grown thick, is moved out to the bark.
    AgeCutter(const GrowthHistory& history, const std::vector<bool>& axes);

    /// The pieces, parents before children.
    [[nodiscard]] const std::vector<Piece>& pieces() const { return m_pieces; }
    /// The skeleton. To be called once. \param ends becomes the metamer at the end of each branch; null:
    /// nobody asks.
    Skeleton draw(std::vector<Index>* ends = nullptr);

private:
    void choose();
    void chooseAll(const std::vector<bool>& axes);
    void addPiece(Index metamer, std::vector<Index>& pieceOf, double radius, double bend, double grown);
    void reach();
    void pose();
    [[nodiscard]] double standOff(const Piece& piece) const;
    void smooth();
    void findStumps();
    void drawPiece(Index k);
    Index firstNode(Index stem);
    Index makeRoom(const Piece& piece, Index below);
    [[nodiscard]] bool isLarge(const Piece& piece) const;
    [[nodiscard]] bool isOnStem(const Piece& piece, Index below) const;
    [[nodiscard]] glm::dvec3 footOf(const Piece& piece) const;
    [[nodiscard]] bool stood(const Piece& piece) const { return piece.metamer < m_history.standing; }
    [[nodiscard]] bool leavesTheWood(const Piece& piece) const;
    [[nodiscard]] bool hasRoom(const Piece& piece, Index below) const;
    [[nodiscard]] bool isKept(const Piece& piece, const glm::dvec3& way, Index below) const;
    [[nodiscard]] double roomBeside(const Piece& piece, const glm::dvec3& direction, Index below) const;
    void add(Index k, Index below, const glm::dvec3& from);
    [[nodiscard]] double footRadius(const Piece& piece) const;
    [[nodiscard]] Index axisOf(Index branch) const { return m_history.axis[m_ends[branch]]; }

    const GrowthHistory& m_history;
    int m_whole;
    double m_part;
    bool m_isWholeLife;
    std::vector<Piece> m_pieces;
    double m_farthest = 0.0; ///< m, reach of the stem
    std::vector<double> m_bends, m_grown;
    std::vector<Index> m_branch; ///< by piece: that ends at it or before
    std::vector<bool> m_out;
    std::vector<Index> m_ends;   ///< by branch: metamer
    std::vector<double> m_above; ///< by branch: m, radius of what goes on from it
    std::vector<Index> m_limbs;  ///< by branch: how many start at its end
    std::vector<Index> m_stumps; ///< axes
    Skeleton m_skeleton;
};

} // namespace ramure::growth
