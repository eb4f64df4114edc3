/// \file
/// Levels of detail of the selected tree before they are exported: how many triangles each has, from which
/// distance it is shown, and how it looks there beside the whole tree.
#pragma once

#include "core/qt/session/export/level_watch.h"
#include <QWidget>
#include <map>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QToolButton;
class QTreeView;
class QVBoxLayout;

namespace ramure {

class EmptyPage;
class LevelForm;
class LevelModel;
class LevelView;
class NumberField;
class NumberSlider;
class Preferences;

class LevelsPanel : public QWidget
{
    Q_OBJECT
public:
    /// Nothing is owned; both must outlive the panel. Levels are made while the panel is seen.
    LevelsPanel(Document* document, Preferences* preferences, QWidget* parent = nullptr);
    /// For tests. \param watch becomes the panel's own
    LevelsPanel(Document* document, LevelWatch* watch, Preferences* preferences, QWidget* parent = nullptr);

    [[nodiscard]] LevelWatch* watch() const { return m_watch; }
    [[nodiscard]] LevelForm* form() const { return m_form; }
    [[nodiscard]] QTreeView* table() const { return m_table; }
    [[nodiscard]] LevelView* levelView() const { return m_levelView; }
    [[nodiscard]] LevelView* wholeView() const { return m_wholeView; }
    /// The levels for an export for games; nothing if nobody has chosen or seen levels yet.
    [[nodiscard]] std::optional<LevelOptions> chosen() const;
    /// m, from the eye to the tree.
    [[nodiscard]] double distance() const { return m_distance; }
    /// The one that is shown; nothing while there are none.
    [[nodiscard]] std::optional<std::size_t> level() const { return m_level; }
    [[nodiscard]] QSize sizeHint() const override { return {384, 400}; }

public slots:
    /// Held to the range of the slider; shows the level that a game shows there.
    void setDistance(double metres);
    /// A panel behind another tab counts as visible to Qt. This says whether it is really seen.
    void setSeen(bool seen);

signals:
    /// The dialog of exports is to open with these.
    void exportRequested(const ramure::LevelOptions& options);
    void messageRaised(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void buildTable(QVBoxLayout* column);
    void buildState(QVBoxLayout* column);
    void buildDistance(QVBoxLayout* column);
    void buildChoices(QVBoxLayout* column);
    void buildPictures(QVBoxLayout* column);
    void connectViews();
    void takeForm();
    void takeEdited(const std::vector<double>& distances, const std::vector<double>& shares);
    void takeStored();
    void takeTree();
    void follow();
    void takeLevels();
    void fitTable();
    void showState();
    void showRow(int row);
    void showLevel(double distance, std::size_t level);
    void showShot();
    void showMenu(const QPoint& at);
    void copy(int firstRow, int count);

    Document* m_document;
    Preferences* m_preferences;
    LevelWatch* m_watch;
    LevelModel* m_model;
    std::shared_ptr<const TreeLevels> m_levels;
    double m_distance = 0.0;
    double m_least = 0.0, m_most = 0.0; ///< m, of the slider
    std::optional<std::size_t> m_level;
    NodeId m_tree = noNode;                         ///< the tree whose distance is kept
    NodeId m_metresOf = noNode;                     ///< the tree whose distances stand in the form
    std::map<NodeId, std::vector<double>> m_metres; ///< distances that were set for the other trees
    QString m_formProblem;                          ///< why the written text is no budget
    QString m_editProblem;                          ///< and why a cell of the table stayed as it was
    bool m_shows = false;                           ///< the row is being chosen by the distance
    QStackedWidget* m_pages = nullptr;
    EmptyPage* m_empty = nullptr;
    QLabel* m_title = nullptr;
    LevelForm* m_form = nullptr;
    QLabel* m_state = nullptr;
    QProgressBar* m_progress = nullptr;
    QToolButton* m_cancel = nullptr;
    QPushButton* m_again = nullptr;
    QTreeView* m_table = nullptr;
    QWidget* m_below = nullptr; ///< all that needs levels
    QLabel* m_distanceLabel = nullptr;
    NumberSlider* m_slider = nullptr;
    NumberField* m_field = nullptr;
    LevelView *m_levelView = nullptr, *m_wholeView = nullptr;
    QLabel *m_levelText = nullptr, *m_wholeText = nullptr, *m_sizeText = nullptr;
    QCheckBox* m_enlarged = nullptr;
    QPushButton* m_export = nullptr;
};

} // namespace ramure
