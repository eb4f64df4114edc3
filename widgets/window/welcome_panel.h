/// \file
/// The welcome page: beside the view, which already shows a tree. Presets as pictures, recent files, first
/// keys.
#pragma once

#include <QFrame>

class QCheckBox;
class QGridLayout;
class QAction;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace ramure {

class ActionSet;
class FileActions;
class Preferences;
class PresetGallery;

class WelcomePanel : public QFrame
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the panel. It is made hidden.
    WelcomePanel(FileActions* files, ActionSet* set, Preferences* preferences, QWidget* parent = nullptr);

    /// With the files and keys of this moment, and the focus on the first picture.
    void open();
    [[nodiscard]] QAction* addAction() const { return m_add; }

signals:
    void closed();
    /// A preset shall stand beside what is there. \param preset as namedTree takes it
    void addRequested(const QString& preset);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void takePreferences();
    void fillRecent();
    void fillHints();
    [[nodiscard]] QLabel* heading(const QString& text);

    FileActions* m_files;
    ActionSet* m_set;
    Preferences* m_preferences;
    QWidget* m_page;
    QToolButton* m_close;
    PresetGallery* m_gallery;
    QAction* m_add;
    QVBoxLayout* m_recent;
    QPushButton* m_open;
    QGridLayout* m_hints;
    QCheckBox* m_atStart;
    QStringList m_shownRecent;
};

} // namespace ramure
