/// \file
/// A tree while hands shape it: pieces that can be split, moved, copied and taken away, in axes that keep
/// their addresses whatever happens beside them. For this folder; everybody else uses edit_context.h.
#pragma once

#include "core/base/progress.h"
#include "core/math/frame.h"
#include "core/skeleton/axes.h"
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <unordered_map>
#include <vector>

namespace ramure {

/// A branch of the skeleton to be.
struct EditPiece
{
    glm::dvec3 p0{0.0}, p1{0.0};
    double a0 = 0.0, a1 = 0.0;
    std::uint64_t key = 0;
    Index parent = noIndex;
    Index next = noIndex; ///< the piece that continues the axis
    Index axis = noIndex;
    Index level = 0;
    Index before = noIndex, after = noIndex; ///< in the order of the skeleton: parents before children
    bool bare = false;                       ///< no leaves
    bool sawn = false;                       ///< its end was cut
    bool loose = false;                      ///< the root of a limb that falls
    Index stump = noIndex;                   ///< what that came off
    double fallsAt = 0.0;                    ///< s: LooseLimb::seconds
    double roll = 0.0;                       ///< rad: Skeleton::rolls
    bool gone = false;
};

struct EditAxis
{
    std::uint64_t address = 0;
    Index first = noIndex;    ///< piece
    std::uint64_t maker = 0;  ///< TreeEdit::id of the graft that made it; 0: none did
    Index original = noIndex; ///< the axis that it is a copy of
};

/// By piece: whether it is meant.
using EditMarks = std::vector<bool>;

/// \copydoc Organ
struct EditOrganSeat : Organ
{
    bool stays = false; ///< also where no leaves grow: it was put there after they went
};

/// A place on an axis.
struct AxisSpot
{
    Index piece = noIndex;
    double t = 1.0; ///< along the piece
};

/// The tree as it can be read.
class PieceTree
{
public:
    [[nodiscard]] std::uint64_t seed() const { return m_seed; }
    /// Null: the edit is not of the life of the tree.
    [[nodiscard]] const LivedEdit* livedWith(std::uint64_t edit) const;
    /// Whether the skeleton that it began with names its axes itself: their addresses hold, whatever stands
    /// where on them by now.
    [[nodiscard]] bool hasOwnAddresses() const { return m_hasOwnAddresses; }
    [[nodiscard]] bool cancelled() const { return m_progress && m_progress->cancelled(); }
    [[nodiscard]] Progress progress() const { return m_progress ? *m_progress : Progress(); }

    /// By axis: whether the step that acts now acts there; empty where it says nothing of axes.
    [[nodiscard]] const std::vector<bool>& meant() const { return m_meant; }
    [[nodiscard]] const std::vector<EditPiece>& pieces() const { return m_pieces; }
    [[nodiscard]] const EditPiece& piece(Index i) const { return m_pieces[i]; }
    /// Those of the generator first, as TreeAxes has them.
    [[nodiscard]] const EditAxis& axis(Index i) const { return m_axes[i]; }
    [[nodiscard]] Index grownAxes() const { return m_grownAxes; }
    [[nodiscard]] Index axisCount() const { return static_cast<Index>(m_axes.size()); } ///< gone ones too
    /// The axes that are there, in the order in which the tree has them (axesOf), whatever steps have made of
    /// it: a frozen tree has its axes in the same order.
    [[nodiscard]] std::vector<Index> axesInOrder() const;
    [[nodiscard]] Index firstPiece() const { return m_head; }
    [[nodiscard]] Index size() const { return m_size; } ///< pieces that are there
    [[nodiscard]] std::size_t bytes() const
    {
        return m_pieces.size() * sizeof(EditPiece) + m_axes.size() * sizeof(EditAxis) +
               m_organs.size() * sizeof(EditOrganSeat);
    }
    [[nodiscard]] bool isGone(Index axis) const { return m_pieces[m_axes[axis].first].gone; }
    /// noIndex: there was none of that address.
    [[nodiscard]] Index axisAt(std::uint64_t address) const;
    /// Of those that edits made: quick.
    [[nodiscard]] Index madeAxisAt(std::uint64_t address) const;

    [[nodiscard]] double length(Index piece) const;
    [[nodiscard]] double axisLength(Index axis) const;
    [[nodiscard]] Index tipOf(Index axis) const; ///< its last piece
    /// \param share of the axis' length. Close to the end of a piece it is that end; at the foot it is a
    /// place on the first piece.
    [[nodiscard]] AxisSpot spotOn(Index axis, double share) const;
    [[nodiscard]] glm::dvec3 pointAt(const AxisSpot& spot) const;
    [[nodiscard]] double radiusAt(const AxisSpot& spot) const;
    /// The frame carried without twist from the root over the piece (Axis::azimuth).
    [[nodiscard]] Frame frameAfter(Index piece) const;
    [[nodiscard]] Frame frameBelow(Index axis) const;

    /// The limb from a piece on.
    [[nodiscard]] EditMarks marked(Index piece) const;
    /// Also from several pieces on.
    [[nodiscard]] EditMarks markedFrom(const std::vector<Index>& pieces) const;
    [[nodiscard]] bool isOn(Index piece, Index limb) const; ///< is the piece the limb's first or above it?
    /// Also of gone pieces.
    [[nodiscard]] const std::vector<EditOrganSeat>& organs() const { return m_organs; }
    /// The tree as it is now, with the addresses of its axes.
    [[nodiscard]] Skeleton skeleton() const;

protected:
    PieceTree(const Skeleton& grown, const TreeAxes& axes, std::uint64_t seed);

    std::vector<EditPiece> m_pieces;
    std::vector<EditAxis> m_axes;
    std::vector<EditOrganSeat> m_organs;             ///< by piece
    std::unordered_map<std::uint64_t, Index> m_made; ///< axes that edits made, by address
    std::vector<LivedEdit> m_lived;
    std::vector<bool> m_meant;
    Index m_grownAxes = 0;
    bool m_hasOwnAddresses = false;
    std::uint64_t m_seed = 0;
    const Progress* m_progress = nullptr;
    Index m_head = noIndex, m_tail = noIndex, m_size = 0;
};

/// The tree as steps change it.
class EditTree : public PieceTree
{
public:
    /// \param seed of the tree, for steps that draw by chance
    EditTree(const Skeleton& grown, const TreeAxes& axes, std::uint64_t seed = 0);

    /// Long steps ask it whether to stop; it must live until the next call.
    void setProgress(const Progress* progress) { m_progress = progress; }
    /// Marks the axes that the next step acts on, see meant().
    void setMeant(std::vector<bool> axes) { m_meant = std::move(axes); }
    using PieceTree::piece;
    [[nodiscard]] EditPiece& piece(Index i) { return m_pieces[i]; }

    /// Names what splits and new pieces get from now on are called by.
    void setMaker(std::uint64_t id);
    /// The piece that ends at the place: split where it has to be.
    Index splitAt(Index axis, double share);
    Index splitAt(const AxisSpot& spot);
    /// Splits at many places in one pass. \param spots those of one piece together, from its start up.
    /// Returns the piece that ends at each spot.
    std::vector<Index> splitAt(std::span<const AxisSpot> spots);
    /// A piece ends at a share of its length; organs beyond it go.
    void shorten(Index piece, double share);
    /// One more, that is seen also on a bare piece.
    void putOrgan(const Organ& organ) { m_organs.push_back({organ, true}); }
    /// No leaves on a piece from now on, or leaves again: those that hands have put there go and come with
    /// them.
    void setBare(Index piece, bool bare);
    void setBare(const EditMarks& pieces);
    /// What a piece carries grows on another one too. \param size times as large
    void copyOrgans(Index from, Index to, double size);
    void remove(const EditMarks& marks);
    /// A new axis on a piece, or, of noIndex, on the ground: pieces are added with extend.
    Index addAxis(std::uint64_t address, std::uint64_t maker = 0, Index original = noIndex);
    /// The next piece of an axis, at the end of \p parent: its last piece, or what its first one stands on;
    /// on the ground, noIndex, it starts at \p from. Returns it.
    Index extend(Index axis, Index parent, const glm::dvec3& from, const glm::dvec3& to, double a0, double a1,
                 Index level);
    /// What starts with a piece stands for itself from now on, a little away from what it stood on, and falls
    /// at a time. Where it starts within an axis, the upper part becomes one of that address.
    void loosen(Index piece, std::uint64_t address, double seconds);
    /// The tree becomes another one, whose axes are told by their addresses: those that it has no more are
    /// gone. \param maker of its new axes
    void become(const Skeleton& tree, const TreeAxes& axes, std::uint64_t maker);
    /// Takes a limb to the end of the order and puts it on another piece.
    void hang(Index axis, Index parent);

    /// Passes over all pieces from the roots up. \p change(piece, turn, along) says how a piece is turned
    /// against its old self, and what leads from its start to its end; both come in as what is below it hands
    /// them on. It returns whether it changed them.
    template <class Change> void carry(Change&& change)
    {
        std::vector<bool> moves(m_pieces.size(), false);
        std::vector<glm::dquat> turned(m_pieces.size(), glm::dquat(1.0, 0.0, 0.0, 0.0));
        for (Index i = m_head; i != noIndex; i = m_pieces[i].after) {
            EditPiece& piece = m_pieces[i];
            const bool carried = piece.parent != noIndex && moves[piece.parent];
            glm::dquat turn = carried ? turned[piece.parent] : glm::dquat(1.0, 0.0, 0.0, 0.0);
            glm::dvec3 along = piece.p1 - piece.p0;
            if (carried)
                along = turn * along;
            const bool changed = change(i, turn, along);
            if (!carried && !changed)
                continue;
            moves[i] = true;
            turned[i] = turn;
            if (carried)
                piece.p0 = m_pieces[piece.parent].p1;
            piece.p1 = piece.p0 + along;
        }
    }

private:
    void takePieces(const Skeleton& tree);
    void takeAxis(Index axis, std::span<const Index> nodes);
    Index splitPiece(Index piece, double from, double t);
    void insertAfter(Index before, Index piece);
    void unlink(Index piece);
    [[nodiscard]] std::uint64_t newKey(std::uint64_t from);

    std::uint64_t m_maker = 0, m_keysMade = 0;
};

/// From a frame's coordinates (normal, binormal, tangent) to tree space, and back.
glm::dvec3 outOf(const Frame& frame, const glm::dvec3& v);
glm::dvec3 into(const Frame& frame, const glm::dvec3& v);
/// The smallest rotation from one direction to another; of half a turn about any axis. \pre unit vectors
glm::dquat rotationBetween(const glm::dvec3& from, const glm::dvec3& to);

} // namespace ramure
