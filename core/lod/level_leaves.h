/// \file
/// Shapes of leaves for levels, and an even part of the fruit, enlarged so that it covers as much as all did.
/// R. L. Cook, J. Halstead, M. Planck, D. Ryu: Stochastic simplification of aggregate detail, SIGGRAPH 2007.
#pragma once

#include "core/params/picture_params.h"
#include "core/surface/foliage/foliage.h"
#include <glm/mat3x3.hpp>
#include <span>

namespace ramure {

/// One leaf as a level has it.
struct LeafShapeOfLevel
{
    LeafForm form;
    FoliageModel model = FoliageModel::Fine;
    TriangleMesh mesh;      ///< one leaf of size 1; a plant's has texture coordinates
    double area = 0.0;      ///< m², of all its triangles
    glm::dvec3 middle{0.0}; ///< middle of its surface
    glm::dmat3 spread{0.0}; ///< m²: mean outer product of the ways from the middle to its surface
    bool isSpray = false;   ///< of leaves that pictures show: all but the mesh are those of the whole leaf
};
/// The simplest: a card where a picture cuts the leaf out of it, or a rhomb.
FoliageModel simplestLeaf(const PictureParams& pictures);
/// From the one that the tree has to the simplest. \param alpha the tree's length. \param cards the simplest
/// of a plant's are sprays (leaf_sprays.h), which stand here with the triangles that one has
std::vector<LeafShapeOfLevel> leafShapesOfLevels(const LeafForm& form, const PictureParams& pictures,
                                                 double alpha, bool cards = false);

/// Widens a leaf so that it covers \p growth times the area, but leaves it longer than wide. Leaves that
/// stand for others grow broad first, so that they end where the others did.
LeafShapeOfLevel broadened(const LeafShapeOfLevel& shape, double growth, double alpha);

/// m²: of all triangles.
double areaOf(const TriangleMesh& mesh);

/// A number in [0, 1) for each item, so that those below any bound are spread evenly over the crown.
std::vector<double> itemChances(std::span<const FoliageItem> items);

/// Chooses \p count of the candidates, those of the lowest random value; returns their numbers, ascending.
/// \param candidates numbers, ascending \param branchOf PrunedTree::branchOf: leaves whose branch is gone go
/// sooner
std::vector<Index> chosenItems(std::span<const FoliageItem> items, std::span<const double> chances,
                               std::span<const Index> candidates, std::span<const Index> branchOf,
                               std::size_t count);

/// Makes the items so large that together they cover \p area, m². \param each m², of one of size 1. \return
/// by how much they have grown.
double enlarge(std::vector<FoliageItem>& items, double area, double each);

} // namespace ramure
