/// \file
/// The trees that ship with the program as pictures, group by group, with a search. The user's own presets
/// come before them, and the favourites come first of all; they also stay in their own groups.
#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace ramure {

class OwnPresets;
class PictureButton;
class Preferences;
struct Preset;

class PresetGallery : public QWidget
{
    Q_OBJECT
public:
    /// \param pictureWidth of each, logical pixels
    /// \param preferences know the favourites; not owned
    PresetGallery(int pictureWidth, Preferences* preferences, QWidget* parent);

    [[nodiscard]] QLineEdit* search() const { return m_search; }
    /// The first picture that is shown, or null.
    [[nodiscard]] QWidget* first() const;
    /// Sets the tip's text about a click on a picture.
    void setClickText(const QString& text);
    /// Adds an entry to the pictures' menu. \param own only for the user's own pictures
    void addChoice(QAction* action, bool own = false);
    void showOwn(const OwnPresets& presets);
    /// A favourite stays one under its new name.
    void followRename(const QString& from, const QString& to);
    /// Name of the preset whose menu was opened last, for namedTree.
    [[nodiscard]] const QString& menuPreset() const { return m_menuPreset; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void chosen(const QString& preset);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Item
    {
        PictureButton* picture;
        const Preset* preset; ///< null: the user's
    };
    struct Group
    {
        const char* name; ///< English, context "core"
        QLabel* heading;
        QGridLayout* grid;
        std::vector<Item> items;
    };

    void addGroup(const char* name);
    void addPicture(Group& group, const QString& id, const QString& name, const Preset* preset);
    void clear(Group& group);
    void showFavourites();
    void changeFavourite(const QString& id);
    void describe(const Item& item);
    void openMenu(PictureButton* picture, const QPoint& at);
    void filter();
    void arrange();
    [[nodiscard]] int columnWidth() const;

    int m_pictureWidth;
    Preferences* m_preferences;
    QLineEdit* m_search;
    QLabel* m_none;
    QString m_clickText;
    std::vector<Group> m_groups; ///< the favourites, the user's, then those of the program
    QList<QAction*> m_choices, m_ownChoices;
    QString m_menuPreset;
    QStringList m_favourites; ///< in the order in which they are shown
    int m_columns = 0;
};

} // namespace ramure
