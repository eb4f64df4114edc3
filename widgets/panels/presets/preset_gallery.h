/// \file
/// The trees that ship with the program as pictures, group by group, with a search.
#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace ramure {

class PictureButton;

/// "SilverBirch": "Silver Birch".
QString spacedName(const QString& preset);

class PresetGallery : public QWidget
{
    Q_OBJECT
public:
    /// \param pictureWidth of each, logical pixels
    PresetGallery(int pictureWidth, QWidget* parent);

    [[nodiscard]] QLineEdit* search() const { return m_search; }
    /// The first picture that is shown, or null.
    [[nodiscard]] QWidget* first() const;
    /// Of a picture's menu, beside what a click does.
    void addChoice(QAction* action);
    /// Whose menu was opened last.
    [[nodiscard]] const QString& menuPreset() const { return m_menuPreset; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void chosen(const QString& preset);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Group
    {
        const char* name; ///< English, context "core"
        QLabel* heading;
        QGridLayout* grid;
        std::vector<PictureButton*> pictures;
    };

    void addPicture(std::size_t preset);
    void openMenu(PictureButton* picture, const QPoint& at);
    void filter();
    void arrange();
    void retranslate();
    [[nodiscard]] int columnWidth() const;

    int m_pictureWidth;
    QLineEdit* m_search;
    QLabel* m_none;
    std::vector<Group> m_groups;
    QList<QAction*> m_choices;
    QString m_menuPreset;
    int m_columns = 0;
};

} // namespace ramure
