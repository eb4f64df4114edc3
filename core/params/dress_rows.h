/// \file
/// Rows of what a tree wears: leaves, fruit, bark and its texture. Internal to param_table.cpp.
#pragma once

#include "core/params/param_rows.h"

namespace ramure::rows {

// Every text stands in one line per clause; the columns of a table read better than those of the formatter.
// clang-format off
inline constexpr std::array dressRows{
    row<&NodeParams::leaf, &LeafParams::shape>(
        {"foliage.leaf", foliageGroup, RAMURE_NOOP("Leaf"),
         RAMURE_NOOP("The plant whose leaves the twigs carry, each on its petiole. Faithful: flat triangles that float about "
                     "the twigs, squares in the rough model.")},
        ParamUnit::None, {}, Stage::Foliage),
    row<&NodeParams::foliage, &FoliageParams::leavesCutoff>(
        {"foliage.leavesCutoff", foliageGroup, RAMURE_NOOP("Twig thickness"),
         RAMURE_NOOP("Branches thinner than this share of the trunk's radius carry leaves and fruit. 0 leaves the tree "
                     "bare.")},
        ParamUnit::Ratio, {0, 10, 0, 1, 0.01, 3}, Stage::Foliage, paramAnimatable),
    row<&NodeParams::foliage, &FoliageParams::leavesDensity>(
        {"foliage.leavesDensity", foliageGroup, RAMURE_NOOP("Leaves per twig"),
         RAMURE_NOOP("Number of leaves on each branch that is thin enough. Leaves of a plant follow their internode instead; for them only 0 has an effect: no leaves.")},
        ParamUnit::Count, {0, 1000, 0, 50, 1, 0}, Stage::Foliage, paramAnimatable, treeOnly, isFaithful),
    row<&NodeParams::leaf, &LeafParams::internode>(
        {"foliage.internode", foliageGroup, RAMURE_NOOP("Internode"),
         RAMURE_NOOP("How far it is along a twig from one node with leaves to the next: 1 as the plant has it.")},
        ParamUnit::Factor, {0.01, 1000, 0.25, 4, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::arrangement>(
        {"foliage.arrangement", foliageGroup, RAMURE_NOOP("Arrangement"),
         RAMURE_NOOP("How the leaves of a twig follow each other. Alternate: one a node, two fifths of a turn apart; in two "
                     "rows: left and right; spiral: 137.5° apart; opposite: pairs in one plane; crossed pairs: each across "
                     "the last; whorled: several a node.")},
        ParamUnit::None, {}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::whorl>(
        {"foliage.whorl", foliageGroup, RAMURE_NOOP("Leaves per node"),
         RAMURE_NOOP("How many leaves of a whorl stand around the twig.")},
        ParamUnit::Count, {1, 24, 3, 12, 1, 0}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::angle>(
        {"foliage.leafAngle", foliageGroup, RAMURE_NOOP("Angle to the twig"),
         RAMURE_NOOP("Between the twig and a petiole before it droops: 0 lies along the twig, a quarter turn stands away.")},
        ParamUnit::Radian, {0, pi, 0.2, pi / 2, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::droop>(
        {"foliage.leafDroop", foliageGroup, RAMURE_NOOP("Droop"),
         RAMURE_NOOP("How far the weight of a leaf pulls it down: 0 keeps the angle to the twig, 1 lets it hang.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Foliage, paramAnimatable, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::light>(
        {"foliage.leafLight", foliageGroup, RAMURE_NOOP("To the light"),
         RAMURE_NOOP("How far a petiole twists to turn the upper side of its leaf to the sky: 0 not at all, 1 as far as it "
                     "goes.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::season, &SeasonParams::day>(
        {"season.day", foliageGroup, RAMURE_NOOP("Day of the year"),
         RAMURE_NOOP("Buds swell and burst, leaves unfold, turn and fall on the days on which those of the plant do in its climate; flowers and "
                     "fruit have theirs. Colours come from pigments. 0: no day, and Season counts.")},
        ParamUnit::Day, {0, 365, 0, 365, 1, 0}, Stage::Season, paramAnimatable, treeOnly, isOfPlant),
    row<&NodeParams::season, &SeasonParams::climate>(
        {"season.climate", foliageGroup, RAMURE_NOOP("Climate"),
         RAMURE_NOOP("Whose winter and summer the day of the year goes by. Oceanic: as in Rennes; continental: as in Cracow; boreal: as "
                     "in Jyväskylä, with a late spring and an early autumn.")},
        ParamUnit::None, {}, Stage::Season, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::season, &SeasonParams::purple>(
        {"season.purple", foliageGroup, RAMURE_NOOP("Purple leaves"),
         RAMURE_NOOP("On a day of the year: leaves are dark red all summer, as those of a copper beech.")},
        ParamUnit::None, {}, Stage::Season, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::season, &SeasonParams::redness>(
        {"season.redness", foliageGroup, RAMURE_NOOP("Red in autumn"),
         RAMURE_NOOP("On a day of the year: how red leaves turn, against those of the plant. At 0 red ones turn yellow, as a Norway "
                     "maple beside a sugar maple.")},
        ParamUnit::Factor, {0, 3, 0, 2, 0.05, 2}, Stage::Season, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::shade>(
        {"foliage.shadeLeaves", foliageGroup, RAMURE_NOOP("Shade leaves"),
         RAMURE_NOOP("Area of a leaf inside the crown, where it is dark, relative to one in full sun: 1 the same, in nature 1.3 to 1.8. Shade leaves are darker, too.")},
        ParamUnit::Factor, {0.25, 4, 1, 2, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::damage>(
        {"foliage.leafDamage", foliageGroup, RAMURE_NOOP("Damaged leaves"),
         RAMURE_NOOP("Share of the leaves that insects, fungi or drought have marked: they are smaller and have withered in part.")},
        ParamUnit::Share, {0, 1, 0, 0.3, 0.01, 3}, Stage::Foliage, paramAnimatable, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::season>(
        {"foliage.season", foliageGroup, RAMURE_NOOP("Season"),
         RAMURE_NOOP("Where there is no day of the year. 0 is summer. Then leaves take the colour of their plant's autumn, the upper ones "
                     "first, and fall, until at 100 % the twigs are bare. Evergreens stay as they are.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 3}, Stage::Foliage, paramAnimatable, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::stiffness>(
        {"foliage.leafStiffness", foliageGroup, RAMURE_NOOP("Petiole stiffness"),
         RAMURE_NOOP("How firmly a petiole holds its leaf against wind and weight: less lets leaves swing far and slowly.")},
        ParamUnit::Factor, {0.05, 20, 0.2, 5, 0.05, 3}, Stage::Motion, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::flutter>(
        {"foliage.leafFlutter", foliageGroup, RAMURE_NOOP("Flutter"),
         RAMURE_NOOP("How much leaves tremble in the wind: 1 as usual, 0 not at all.")},
        ParamUnit::Factor, {0, 4, 0, 2, 0.05, 3}, Stage::Motion, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::length>(
        {"foliage.leafLength", foliageGroup, RAMURE_NOOP("Leaf length"),
         RAMURE_NOOP("Length of a leaf of the mean size, without its petiole; of needles, that of the shoot which carries them. Longer leaves stand farther apart: see Internode. 0: the leaves grow with the radius of the trunk.")},
        ParamUnit::Metre, {0, 20, 0, 0.5, 0.005, 4}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::perShoot>(
        {"foliage.leavesPerShoot", foliageGroup, RAMURE_NOOP("Leaves per shoot"),
         RAMURE_NOOP("1: every leaf stands on a branch. More: in its place there is a short shoot with so many leaves, which sways as one.")},
        ParamUnit::Count, {1, 40, 1, 12, 1, 0}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::size>(
        {"foliage.leafSize", foliageGroup, RAMURE_NOOP("Leaf size"),
         RAMURE_NOOP("Multiplies the length of all leaves; 0 leaves the twigs bare.")},
        ParamUnit::Factor, {0, 100, 0.2, 3, 0.05, 3}, Stage::Foliage, paramAnimatable, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::variation>(
        {"foliage.leafVariation", foliageGroup, RAMURE_NOOP("Size varies"),
         RAMURE_NOOP("How far one leaf may be larger or smaller than the others.")},
        ParamUnit::Share, {0, 0.9, 0, 0.6, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::width>(
        {"foliage.leafWidth", foliageGroup, RAMURE_NOOP("Leaf width"),
         RAMURE_NOOP("1 as the plant has it, more makes broader leaves. Leaflets end where their neighbours begin.")},
        ParamUnit::Factor, {0.05, 2, 0.3, 2, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::petiole>(
        {"foliage.petiole", foliageGroup, RAMURE_NOOP("Petiole"),
         RAMURE_NOOP("Length of the stalk between bark and blade: 1 as the plant has it, 0 none.")},
        ParamUnit::Factor, {0, 10, 0, 3, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::fold>(
        {"foliage.leafFold", foliageGroup, RAMURE_NOOP("Fold"),
         RAMURE_NOOP("How far both halves of a blade rise from its midrib.")},
        ParamUnit::Radian, {0, 1.3, 0, 1.2, 0.05, 3}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::curl>(
        {"foliage.leafCurl", foliageGroup, RAMURE_NOOP("Curl"),
         RAMURE_NOOP("How far a blade bends down from its foot to its tip. Negative values bend it up.")},
        ParamUnit::Radian, {-pi / 2, pi, -0.5, 2, 0.05, 3}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::cup>(
        {"foliage.leafCup", foliageGroup, RAMURE_NOOP("Cup"),
         RAMURE_NOOP("1 hollows a blade like a spoon, -1 arches it, 0 leaves its halves even.")},
        ParamUnit::Ratio, {-1, 1, -1, 1, 0.05, 3}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::leaf, &LeafParams::detail>(
        {"foliage.leafDetail", foliageGroup, RAMURE_NOOP("Leaf detail"),
         RAMURE_NOOP("1 draws a leaf with the fewest triangles, 3 with the smoothest outline.")},
        ParamUnit::Count, {1, 3, 1, 3, 1, 0}, Stage::Foliage, paramAdvanced, treeOnly, isOfPlant),
    row<&NodeParams::foliage, &FoliageParams::applesProbability>(
        {"foliage.applesProbability", foliageGroup, RAMURE_NOOP("Amount of fruit"),
         RAMURE_NOOP("The chance that a branch which is thin enough carries fruit, of the kind below: 0 for none, "
                     "1 for one on each.")},
        ParamUnit::Ratio, {0, 1, 0, 1, 0.01, 3}, Stage::Foliage, paramAnimatable),
    row<&NodeParams::fruit, &FruitParams::kind>(
        {"foliage.fruit", foliageGroup, RAMURE_NOOP("Fruit"),
         RAMURE_NOOP("Fruit or flowers on the twigs: fruit hang on their stalks, blossom faces the light. Faithful: a sphere about the twig, a cube in the rough model.")},
        ParamUnit::None, {}, Stage::Foliage),
    row<&NodeParams::fruit, &FruitParams::diameter>(
        {"foliage.fruitDiameter", foliageGroup, RAMURE_NOOP("Fruit diameter"),
         RAMURE_NOOP("Diameter of a fruit or flower of the mean size, at its widest. 0: fruit grow with the radius of the trunk.")},
        ParamUnit::Metre, {0, 10, 0, 0.3, 0.005, 4}, Stage::Foliage, paramAnimatable, treeOnly, isHung),
    row<&NodeParams::fruit, &FruitParams::size>(
        {"foliage.fruitSize", foliageGroup, RAMURE_NOOP("Fruit size"),
         RAMURE_NOOP("Multiplies the diameter of all fruit; 0 leaves the tree without.")},
        ParamUnit::Factor, {0, 100, 0.2, 4, 0.05, 3}, Stage::Foliage, paramAnimatable, treeOnly, isHung),
    row<&NodeParams::fruit, &FruitParams::stalk>(
        {"foliage.fruitStalk", foliageGroup, RAMURE_NOOP("Fruit stalk"),
         RAMURE_NOOP("Length of the stalk: 1 as the plant has it, 0 none.")},
        ParamUnit::Factor, {0, 20, 0, 4, 0.05, 3}, Stage::Foliage, paramNone, treeOnly, isHung),
    row<&NodeParams::fruit, &FruitParams::cluster>(
        {"foliage.fruitCluster", foliageGroup, RAMURE_NOOP("Fruit per cluster"),
         RAMURE_NOOP("How many fruit or flowers hang from one place: 0 as the plant has it.")},
        ParamUnit::Count, {0, 60, 0, 30, 1, 0}, Stage::Foliage, paramNone, treeOnly, isHung),
    row<&NodeParams::fruit, &FruitParams::ripeness>(
        {"foliage.fruitRipeness", foliageGroup, RAMURE_NOOP("Ripe fruit"),
         RAMURE_NOOP("At 100 % all fruit have their last colour; below, some are still green, each as far as its place and chance let it.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 3}, Stage::Foliage, paramAnimatable, treeOnly, isHung),
    row<&NodeParams::foliage, &FoliageParams::seed>(
        {"foliage.seed", foliageGroup, RAMURE_NOOP("Seed of the leaves"),
         RAMURE_NOOP("Another seed arranges leaves and apples anew; the branches stay as they are.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Foliage, paramSeed),

    row<&NodeParams::bark, &BarkParams::family>(
        {"bark.family", barkGroup, RAMURE_NOOP("Bark"),
         RAMURE_NOOP("Kind of bark. The program makes its picture, which repeats without a seam.")},
        ParamUnit::None, {}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::depth>(
        {"bark.depth", barkGroup, RAMURE_NOOP("Depth"),
         RAMURE_NOOP("How deep cracks and furrows look: 1 as is usual for this bark, 0 flat.")},
        ParamUnit::Ratio, {0, 5, 0, 2, 0.05, 3}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::light>(
        {"bark.light", barkGroup, RAMURE_NOOP("Lighter"),
         RAMURE_NOOP("Makes the bark lighter. Negative values make it darker.")},
        ParamUnit::Share, {-1, 1, -0.5, 0.5, 0.01, 3}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::moss>(
        {"bark.moss", barkGroup, RAMURE_NOOP("Moss"),
         RAMURE_NOOP("How much of the bark moss covers. It begins in the cracks.")},
        ParamUnit::Share, {0, 1, 0, 1, 0.01, 3}, Stage::Texture),
    row<&NodeParams::bark, &BarkParams::seed>(
        {"bark.seed", barkGroup, RAMURE_NOOP("Seed of the bark"),
         RAMURE_NOOP("Another seed draws another piece of the same bark.")},
        ParamUnit::None, {0, maxSeed, 0, 9999, 1, 0}, Stage::Texture, paramSeed),
    row<&NodeParams::texture, &TextureParams::tileSize>(
        {"texture.tileSize", barkGroup, RAMURE_NOOP("Bark tile"),
         RAMURE_NOOP("Side of the piece of bark that is repeated, on the thickest wood. It is smaller on thinner wood, "
                     "and a whole number of them goes around every branch. 0: four go around the trunk.")},
        ParamUnit::Metre, {0, 1000, 0, 0.1, 0.001, 4}, Stage::Texture, paramAdvanced),
    pictureRow<&NodeParams::barkPictures, &PictureParams::colour>("bark.colourPicture", barkPicturesGroup),
    pictureRow<&NodeParams::barkPictures, &PictureParams::normal>("bark.normalPicture", barkPicturesGroup),
    pictureRow<&NodeParams::barkPictures, &PictureParams::roughness>("bark.roughnessPicture", barkPicturesGroup),
    pictureRow<&NodeParams::barkPictures, &PictureParams::height>("bark.heightPicture", barkPicturesGroup),
    pictureRow<&NodeParams::barkPictures, &PictureParams::occlusion>("bark.occlusionPicture", barkPicturesGroup),
    pictureRow<&NodeParams::leafPictures, &PictureParams::colour>("foliage.leafColourPicture", leafPicturesGroup),
    pictureRow<&NodeParams::leafPictures, &PictureParams::normal>("foliage.leafNormalPicture", leafPicturesGroup),
    pictureRow<&NodeParams::leafPictures, &PictureParams::roughness>("foliage.leafRoughnessPicture", leafPicturesGroup),
    pictureRow<&NodeParams::leafPictures, &PictureParams::height>("foliage.leafHeightPicture", leafPicturesGroup),
    pictureRow<&NodeParams::leafPictures, &PictureParams::occlusion>("foliage.leafOcclusionPicture", leafPicturesGroup),
    pictureRow<&NodeParams::leafPictures, &PictureParams::opacity>("foliage.leafOpacityPicture", leafPicturesGroup),
    pictureRow<&NodeParams::fruitPictures, &PictureParams::colour>("foliage.fruitColourPicture", fruitPicturesGroup),
    pictureRow<&NodeParams::fruitPictures, &PictureParams::normal>("foliage.fruitNormalPicture", fruitPicturesGroup),
    pictureRow<&NodeParams::fruitPictures, &PictureParams::roughness>("foliage.fruitRoughnessPicture", fruitPicturesGroup),
    pictureRow<&NodeParams::fruitPictures, &PictureParams::height>("foliage.fruitHeightPicture", fruitPicturesGroup),
    pictureRow<&NodeParams::fruitPictures, &PictureParams::occlusion>("foliage.fruitOcclusionPicture", fruitPicturesGroup),
};
// clang-format on

} // namespace ramure::rows
