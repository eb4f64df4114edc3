#include "core/presets/species.h"

namespace ramure {
namespace {

// clang-format off
/// Foot S, trunk T, bunches B of fruit, crown K of fronds P, whose pieces Q carry leaflets L; r turns from one
/// to the next.
constexpr const char* turns = "r = 137.5";
constexpr const char* coconutAxiom = "!(0.68)F(0.05)!(0.75)F(0.08)!(0.765)F(0.09)!(0.76)F(0.08)S(0)T(0)!(0.22)F(0.14)B(0)F(0.04)K(0)";
constexpr const char* coconutRules = R"(S(n) : n < 8 -> &(2.2)F(0.16)!(0.36+0.4*0.94^((n+1)*(n+1)))S(n+1)
T(n) : n < 24 -> ^(0.6)F(0.75)!(0.36-0.005*n)T(n+1)
B(n) : n < 4 -> [/(n*90+35)&(62+n*4)!(0.06)F(0.2)&(35)F(0.16)&(30)N(0)]F(0.04)B(n+1)
N(k) : k < 2 -> F(0.1)[/(k*60)&(60)~(fruit,0.24)][/(k*60+120)&(64)~(fruit,0.25)][/(k*60+240)&(58)~(fruit,0.23)]N(k+1)
K(n) : n < 7 -> [/(n*4*r)&(104-n*13)P(0)][/(n*4*r+r)&(101-n*13)P(0)][/(n*4*r+2*r)&(97-n*13)P(0)][/(n*4*r+3*r)&(94-n*13)P(0)]F(0.08)!(0.2-0.018*n)K(n+1)
P(m) : m < 20 -> Q(m)Q(m+1)P(m+2)
P(m) -> F(0.07)!(0.006)[+(22)&(8)~(leaf,0.26)][-(22)&(8)~(leaf,0.26)]~(leaf,0.28)
Q(m) : m == 0 -> !(0.06)F(0.2)!(0.053)&(2)F(0.2)!(0.048)&(2)F(0.2)L(0)!(0.045)&(2)
Q(m) -> F(0.066)!(0.046-0.0019*m)L(m)&(2.7)F(0.066)!(0.045-0.0019*m)L(m+0.5)&(2.7)
L(m) -> [+(64-1.7*m)&(26)~(leaf,min(0.75+0.1*m,1.1-0.035*m))][-(64-1.7*m)&(26)~(leaf,min(0.75+0.1*m,1.1-0.035*m))]
)";
constexpr const char* datePalmAxiom = "!(0.7)F(0.05)!(0.74)F(0.1)!(0.74)F(0.06)S(0)T(0)!(0.44)F(0.14)!(0.38)F(0.05)B(0)K(0)";
constexpr const char* datePalmRules = R"(S(n) : n < 7 -> F(0.14)!(0.56+0.18*0.93^((n+1)*(n+1)))S(n+1)
T(n) : n < 24 -> F(0.44)!(0.56-0.0015*n)T(n+1)
B(n) : n < 6 -> [/(n*140+20)&(46)!(0.045)F(0.4)&(24)F(0.3)&(38)F(0.25)&(34)D(0)]F(0.06)B(n+1)
D(k) : k < 3 -> F(0.06)!(0.03)[/(k*100)&(24)~(fruit,0.05)][/(k*100+60)&(38)~(fruit,0.052)][/(k*100+120)&(28)~(fruit,0.05)][/(k*100+180)&(42)~(fruit,0.048)][/(k*100+240)&(30)~(fruit,0.052)][/(k*100+300)&(36)~(fruit,0.05)]D(k+1)
K(n) : n < 9 -> [/(n*4*r)&(114-n*13)P(0)][/(n*4*r+r)&(111-n*13)P(0)][/(n*4*r+2*r)&(108-n*13)P(0)][/(n*4*r+3*r)&(105-n*13)P(0)]F(0.1)!(0.34-0.028*n)K(n+1)
P(m) : m < 22 -> Q(m)Q(m+1)P(m+2)
P(m) -> F(0.08)!(0.006)[+(20)^(6)~(leaf,0.3)][-(20)^(6)~(leaf,0.3)]~(leaf,0.32)
Q(m) : m == 0 -> !(0.066)F(0.2)!(0.056)&(0.5)F(0.2)L(0)!(0.049)&(1)
Q(m) -> F(0.07)!(0.049-0.0019*m)L(m)&(0.8)F(0.07)!(0.048-0.0019*m)L(m+0.5)&(0.8)
L(m) -> [+(52-0.9*m)^(16)~(leaf,min(0.3+0.1*m,0.7-0.016*m))][-(52-0.9*m)^(16)~(leaf,min(0.3+0.1*m,0.7-0.016*m))]
)";
constexpr const char* fanPalmAxiom = "!(1.12)F(0.06)!(1.19)F(0.1)!(1.2)F(0.08)S(0)T(0)!(0.6)F(0.16)!(0.5)F(0.06)K(0)";
constexpr const char* fanPalmRules = R"(S(n) : n < 8 -> F(0.16)!(0.83+0.36*0.94^((n+1)*(n+1)))S(n+1)
T(n) : n < 20 -> F(0.4)!(0.83-0.006*n)T(n+1)
K(n) : n < 9 -> [/(n*4*r)&(112-n*12)!(0.05)P(0)][/(n*4*r+r)&(109-n*12)!(0.05)P(0)][/(n*4*r+2*r)&(106-n*12)!(0.05)P(0)][/(n*4*r+3*r)&(103-n*12)!(0.05)P(0)]F(0.14)!(0.46-0.044*n)K(n+1)
P(m) : m < 4 -> F(0.43)!(0.044-0.005*m)&(3)P(m+1)
P(m) : m == 4 -> F(0.2)~(leaf,1.15)P(5)
)";
constexpr const char* treeFernRules = R"(T(n) : n < 6 -> &(1.5)F(0.3)!(0.24-0.006*n)F(0.3)T(n+1)
K(n) : n < 10 -> F(0.06)[/(n*3*r)&(22+n*7)~(leaf,2.4)][/(n*3*r+r)&(24+n*7)~(leaf,2.6)][/(n*3*r+2*r)&(26+n*7)~(leaf,2.3)]K(n+1)
)";
/// Arms A and B end in bunches L.
constexpr const char* joshuaTreeRules = R"(A(s,n) : n < 3 -> !(0.38*s)F(0.8*s)[/(n*70)&(38)B(s*0.86,n)][/(n*70+125)&(46)B(s*0.82,n)][/(n*70+240)&(42)B(s*0.8,n)]
A(s,n) -> L(0)
B(s,n) -> !(0.28*s)F(0.8*s)^(9)F(0.8*s)A(s*0.95,n+1)
L(k) : k < 3 -> !(0.2)F(0.16)[/(k*4*r)&(25+k*30)~(leaf,0.65)][/(k*4*r+r)&(28+k*30)~(leaf,0.65)][/(k*4*r+2*r)&(31+k*30)~(leaf,0.65)][/(k*4*r+3*r)&(35+k*30)~(leaf,0.65)][/(k*4*r+35)&(40+k*28)~(leaf,0.6)][/(k*4*r+160)&(50+k*27)~(leaf,0.6)][/(k*4*r+280)&(45+k*27)~(leaf,0.6)]/(61)[/(k*4*r)&(25+k*30)~(leaf,0.65)][/(k*4*r+r)&(28+k*30)~(leaf,0.65)][/(k*4*r+2*r)&(31+k*30)~(leaf,0.65)][/(k*4*r+3*r)&(35+k*30)~(leaf,0.65)][/(k*4*r+35)&(40+k*28)~(leaf,0.6)][/(k*4*r+160)&(50+k*27)~(leaf,0.6)][/(k*4*r+280)&(45+k*27)~(leaf,0.6)]L(k+1)
)";
/// Rhizomes R bear culms C; these have twigs T with sprays B and tufts W of leaves from the seventh node on.
constexpr const char* bambooRules = R"(K(n) : n < 21 -> [/(n*r)&(84)R(n)][/(n*r+r)&(84)R(n+1)][/(n*r+2*r)&(84)R(n+2)]K(n+3)
R(n) -> !(0.09)F(0.08+0.15*sqrt(n))^(34)F(0.05)^(rand(36,50))!(0.085)/(rand(0,360))C(0,rand(0.62,1.05),rand(0,360),rand(0.05,0.3))
C(m,s,d,e) : m < 24 -> !((0.08-0.0027*m)*s)F(0.38*s)T(m)/(d)&(e*m)\(d)!((0.079-0.0027*m)*s)F(0.38*s)T(m+1)/(d)&(e*m)\(d)C(m+2,s,d,e)
C(m,s,d,e) -> W(0)
T(m) : m > 5 && rand(0,1) < 0.85 -> [/(m*180+rand(-75,75))&(rand(35,55))!(0.014)F(0.25)B(0,0.45)][/(m*180+rand(-110,110))&(rand(45,70))!(0.01)F(0.18)W(0)][/(m*180+rand(-110,110))&(rand(45,70))!(0.01)F(0.22)W(0)]
B(k,l) : k < 3 -> [/(rand(0,360))&(45)!(0.007)F(l*0.4)W(0)]&(rand(2,12))!(0.012-0.002*k)F(l*0.6)B(k+1,l*0.8)
B(k,l) -> W(0)
W(k) : k < 2 -> !(0.005)F(0.06)[/(k*180)&(50)~(leaf,0.32)]&(6)F(0.06)[/(k*180+180)&(50)~(leaf,0.32)]&(6)W(k+1)
W(k) -> [&(15)~(leaf,0.32)]
)";
/// Limbs L rise beside the trunk; A goes on with them, X is a wreath of flowers.
constexpr const char* saguaroRules = R"(T(n) : n < 9 -> F(0.45)!(0.42+0.012*n)F(0.4)!(0.425+0.012*n)L(n)T(n+1)
T(n) -> F(0.4)!(0.46)F(0.35)!(0.38)F(0.16)!(0.26)F(0.08)!(0.12)F(0.03)X(0)
L(n) : n > 2 && rand(0,1) < 0.62-0.03*n -> [/(n*r+rand(-30,30))&(92)!(0.26)F(0.3)!(0.3)F(0.2)^(rand(20,26))F(0.2)^(24)F(0.18)^(24)!(0.33)F(0.25)^(20)F(0.3)A(0,rand(2,5.5-0.4*n))]
A(k,m) : k < m -> F(0.35)!(0.34)A(k+1,m)
A(k,m) -> F(0.2)!(0.27)F(0.1)!(0.18)F(0.05)!(0.09)F(0.02)X(0)
X(k) : k < 5 && rand(0,1) < 0.7 -> [/(k*r)&(55)~(fruit,0.24)]X(k+1)
)";
// clang-format on

struct Plant
{
    const char* axiom;
    const char* rules;
    std::int64_t iterations;
    LeafShape leaf;
    double leafWidth, leafCurl;
    BarkFamily bark;
    FruitKind fruit = FruitKind::Faithful;
    bool byChance = false;
    int sides = 8;     ///< of a cross-section
    int divisions = 3; ///< of a piece along its axis
};

/// In metres and degrees. Nothing grows but what the rules say.
NodeParams paramsOf(const Plant& plant)
{
    NodeParams params;
    params.grammar = {
        plant.axiom, plant.rules, plant.iterations, plant.byChance, 1, GrammarDialect::Parametric, turns};
    params.leaf.shape = plant.leaf;
    params.leaf.width = plant.leafWidth;
    params.leaf.curl = plant.leafCurl;
    params.foliage.leavesCutoff = 0.0;
    params.foliage.applesProbability = 0.0;
    params.fruit.kind = plant.fruit;
    params.bark.family = plant.bark;
    params.simplify.enabled = false; // a crown is thinner than the trunk it goes on from
    params.sections = {plant.divisions, plant.sides};
    params.mesh.clampOvershoot = true;
    return params;
}

} // namespace

std::vector<Preset> organPresets()
{
    constexpr const char* group = RAMURE_NOOP("Palms, bamboos and cacti");
    NodeParams fanPalm = paramsOf({fanPalmAxiom, fanPalmRules, 26, LeafShape::FanPalm, 1, 0.5,
                                   BarkFamily::PalmScars, FruitKind::Faithful, false, 16, 2});
    fanPalm.leaf.petiole = 0.15; // its stalks are branches
    fanPalm.bark.depth = 0.5;
    return {
        {"Bamboo", RAMURE_NOOP("A clump of green canes that lean outwards under their leaves"),
         paramsOf({"!(0.14)F(0.06)K(0)", bambooRules, 26, LeafShape::Bamboo, 1, 0.6, BarkFamily::Bamboo,
                   FruitKind::Faithful, true}),
         "Bambusa textilis", group},
        {"CoconutPalmRules", RAMURE_NOOP("A slim leaning trunk with a mop of feather fronds"),
         paramsOf({coconutAxiom, coconutRules, 26, LeafShape::Willow, 0.36, 0.5, BarkFamily::PalmScars,
                   FruitKind::Coconut, false, 16, 2}),
         "Cocos nucifera", group},
        {"DatePalm", RAMURE_NOOP("A straight column under a fountain of stiff fronds"),
         paramsOf({datePalmAxiom, datePalmRules, 26, LeafShape::Willow, 0.55, 0.1, BarkFamily::PalmBoots,
                   FruitKind::Dates, false, 16, 2}),
         "Phoenix dactylifera", group},
        {"FanPalm", RAMURE_NOOP("A stout column below a head of fans"), fanPalm, "Washingtonia filifera",
         group},
        {"JoshuaTree", RAMURE_NOOP("Forking corky arms that end in bunches of daggers"),
         paramsOf({"!(0.7)F(0.6)!(0.5)F(1.0)A(1,0)", joshuaTreeRules, 9, LeafShape::Grass, 2, 0,
                   BarkFamily::Corky}),
         "Yucca brevifolia", group},
        {"Saguaro", RAMURE_NOOP("A ribbed green column with raised arms and white flowers"),
         paramsOf({"!(0.34)F(0.3)!(0.4)T(0)", saguaroRules, 20, LeafShape::Faithful, 1, 0, BarkFamily::Ribbed,
                   FruitKind::Blossom, true, 20}),
         "Carnegiea gigantea", group},
        {"TreeFern", RAMURE_NOOP("A fibrous trunk with a parasol of ferns"),
         paramsOf({"!(0.34)F(0.2)!(0.26)T(0)K(0)", treeFernRules, 16, LeafShape::Fern, 1, 1.1,
                   BarkFamily::Fibrous}),
         "Dicksonia antarctica", group},
    };
}

} // namespace ramure
