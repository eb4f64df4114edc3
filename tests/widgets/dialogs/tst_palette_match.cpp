#include "tests/widgets/base/fixture.h"
#include "widgets/dialogs/palette/palette_match.h"

namespace tst_palette_match {

using namespace ramure;

namespace {

PaletteItem titled(const char* title, const char* id = "")
{
    PaletteItem item;
    item.title = QString::fromUtf8(title);
    item.id = QString::fromUtf8(id);
    return item;
}

} // namespace

class TestPaletteMatch : public QObject
{
    Q_OBJECT
private slots:
    void init() { test::failOnWidgetWarning(); }

    void ranksAreAsTheyAreSaid_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<int>("rank"); // -1: not found
        QTest::newRow("title begins") << "fra" << int(MatchRank::Prefix);
        QTest::newRow("any order") << "sel fra" << int(MatchRank::Prefix);
        QTest::newRow("word begins") << "sel" << int(MatchRank::WordStart);
        QTest::newRow("inside") << "lect" << int(MatchRank::Inside);
        QTest::newRow("beside the title") << "view" << int(MatchRank::Around);
        QTest::newRow("in a longer word beside the title") << "vie" << int(MatchRank::Within);
        QTest::newRow("only letters") << "fsel" << int(MatchRank::Letters);
        QTest::newRow("two letters are too few") << "fe" << -1;
        QTest::newRow("not there") << "frame tree" << -1;
    }
    void ranksAreAsTheyAreSaid()
    {
        QFETCH(const QString, typed);
        QFETCH(const int, rank);
        PaletteItem item = titled("Frame selection", "view.frameSelection");
        item.words = item.id;
        const auto found = matchRank(item, typed.split(u' '));
        QCOMPARE(found ? int(*found) : -1, rank);
    }

    void betterMatchesComeFirstThenWhatWasUsed()
    {
        const std::vector<PaletteItem> items{titled("Unwrap the grid", "a"), titled("Show the grid", "b"),
                                             titled("Grid size", "c"), titled("Hide the grid", "d")};
        using Order = std::vector<std::size_t>;
        QCOMPARE(rankedItems(items, QStringLiteral("grid"), {}), (Order{2, 0, 1, 3}));
        // What was used comes first among equals, never before better ones.
        QCOMPARE(rankedItems(items, QStringLiteral("GRID"), {paletteName(items[3])}), (Order{2, 3, 0, 1}));
        QCOMPARE(rankedItems(items, {}, {paletteName(items[1])}), (Order{1, 0, 2, 3}));
        // What cannot be done now comes last among equals.
        std::vector<PaletteItem> disabled = items;
        disabled[0].enabled = false;
        QCOMPARE(rankedItems(disabled, QStringLiteral("grid"), {}), (Order{2, 1, 3, 0}));
        // What has it inside a longer word is an answer only where nothing better is there.
        std::vector<PaletteItem> others{titled("Rewind"), titled("Tour"), titled("Wind speed"),
                                        titled("Leaves")};
        others[1].words = QStringLiteral("A round through the window");
        others[3].words = QStringLiteral("They move in the wind");
        QCOMPARE(rankedItems(others, QStringLiteral("wind"), {}), (Order{2, 3}));
        others[2].title = QStringLiteral("Speed");
        QCOMPARE(rankedItems(others, QStringLiteral("wind"), {}), (Order{0, 3, 1}));
        // Accents do not count.
        QCOMPARE(rankedItems({titled("Insérer des clés")}, QStringLiteral("cles INSE"), {}).size(), 1U);
    }
};

RAMURE_SUITE(TestPaletteMatch)

} // namespace tst_palette_match

#include "tst_palette_match.moc"
