/// \file
/// "Variations…": many trees from one, by other seeds and by parameters spread over ranges, as pictures in a
/// grid. The good ones get a star, one is opened in the tree's place, or kept as a preset; a table of them is
/// what `ramure-cli batch` grows.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/dialogs/variations/variations_model.h"
#include "widgets/view/tree_pictures.h"
#include <QDialog>
#include <QTimer>

class QLabel;
class QListView;
class QMenu;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace ramure {

class Chooser;
class Preferences;
class VariedParamsForm;

/// Not modal; stays open, so that one choice can follow another.
class VariationsDialog : public QDialog
{
    Q_OBJECT
public:
    static constexpr int usualCount = 24, mostCount = 500;

    /// None is owned; all must outlive the dialog.
    VariationsDialog(Document* document, Preferences* preferences, Chooser* chooser, QWidget* parent);

    /// Begins with this tree, or goes on with it where nothing else has changed it since. \pre a tree
    void offerFor(NodeId tree);
    [[nodiscard]] VariationsModel* model() const { return m_model; }
    [[nodiscard]] VariedParamsForm* form() const { return m_form; }
    [[nodiscard]] QListView* view() const { return m_view; }
    [[nodiscard]] QSpinBox* countField() const { return m_count; }
    [[nodiscard]] QPushButton* otherButton() const { return m_other; }
    [[nodiscard]] QPushButton* stopButton() const { return m_stop; }
    [[nodiscard]] QLabel* hint() const { return m_hint; }
    [[nodiscard]] QAction* openAction() const { return m_open; }
    [[nodiscard]] QAction* starAction() const { return m_star; }
    [[nodiscard]] QAction* keepAction() const { return m_keep; }
    [[nodiscard]] QAction* saveAction(VariationsModel::Choice choice) const
    {
        return m_save[std::size_t(choice)];
    }

signals:
    /// The user's presets have one more.
    void presetKept();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildActions();
    void buildLayout();
    void begin(std::int64_t firstSeed);
    void drawNext();
    void stopOrGoOn();
    void openCurrent();
    void starCurrent();
    void keepCurrent();
    void save(VariationsModel::Choice choice);
    [[nodiscard]] int current() const;
    void follow();
    void say(const QString& text);

    Document* m_document;
    Preferences* m_preferences;
    Chooser* m_chooser;
    Node m_like;
    NodeParams m_opened; ///< the last variation that the tree was turned into
    std::vector<const ParamDef*> m_touched;
    NodeId m_tree = noNode;
    std::int64_t m_first = 1;
    /// The oldest tree's camera if ages vary: the others are drawn to its scale.
    std::optional<Camera> m_scale;
    bool m_isStopped = false;
    QString m_said; ///< until something else happens

    VariationsModel* m_model;
    QListView* m_view;
    VariedParamsForm* m_form;
    QLabel* m_countLabel;
    QSpinBox* m_count;
    QLabel* m_hint;
    QProgressBar* m_progress;
    QPushButton *m_other, *m_stop, *m_close, *m_openButton, *m_table;
    QMenu* m_tableMenu;
    QAction *m_open, *m_star, *m_keep;
    std::array<QAction*, 3> m_save{}; ///< by VariationsModel::Choice
    QTimer m_soon;                    ///< until a number that is dragged rests
    TreePictures m_pictures;
};

} // namespace ramure
