/// \file
/// Content of the gallery dock: a click adds a tree to the scene, the menu gives its numbers to the trees
/// that are selected, a drag puts it into the view. Others of its kind are offered. Trees of the
/// scene can be kept here.
#pragma once

#include "core/qt/document/project/own_presets.h"
#include <QSet>
#include <QWidget>
#include <functional>

class QAction;
class QLabel;
class QPushButton;

namespace ramure {

class Document;
class Preferences;
class PresetGallery;
class TreePictures;
struct Error;

class GalleryPanel : public QWidget
{
    Q_OBJECT
public:
    /// Neither is owned; both must outlive the panel.
    GalleryPanel(Document* document, Preferences* preferences, QWidget* parent = nullptr);
    ~GalleryPanel() override;

    [[nodiscard]] PresetGallery* gallery() const { return m_gallery; }
    [[nodiscard]] QAction* addAction() const { return m_add; }
    [[nodiscard]] QAction* newAction() const { return m_new; }
    [[nodiscard]] QAction* giveAction() const { return m_give; }
    [[nodiscard]] QPushButton* keepButton() const { return m_keep; }
    [[nodiscard]] QAction* renameAction() const { return m_rename; }
    [[nodiscard]] QAction* removeAction() const { return m_remove; }
    /// The user's presets were changed elsewhere.
    void refreshOwn();
    [[nodiscard]] QSize sizeHint() const override;

signals:
    /// \param like has no id.
    void moreRequested(const Node& like);
    /// One with this tree alone. \param preset as namedTree takes it
    void sceneRequested(const QString& preset);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void offerChoices();
    void add(const QString& preset);
    void give(const QString& preset);
    void keep();
    void rename();
    void remove();
    void askName(const QString& title, const QString& suggestion,
                 std::function<Expected<void>(const QString&)> use);
    void drawMissing();
    void complain(const Error& error);
    void follow();

    Document* m_document;
    PresetGallery* m_gallery;
    QLabel* m_problem;
    QLabel* m_what;
    QAction* m_add;
    QAction* m_new;
    QAction* m_give;
    QAction* m_more;
    QAction* m_rename;
    QAction* m_remove;
    QAction* m_reveal;
    QPushButton* m_keep;
    OwnPresets m_own;
    std::unique_ptr<TreePictures> m_pictures; ///< once one was missing
    QSet<QString> m_undrawn; ///< names of presets without a picture, because they cannot be drawn
};

} // namespace ramure
