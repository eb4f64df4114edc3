/// \file
/// Content of the gallery dock: a click adds a tree to the scene, the menu gives its numbers to the trees
/// that are selected, a drag puts it into the view.
#pragma once

#include <QWidget>

class QAction;
class QLabel;

namespace ramure {

class Document;
class PresetGallery;
struct Error;

class GalleryPanel : public QWidget
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the panel.
    explicit GalleryPanel(Document* document, QWidget* parent = nullptr);

    [[nodiscard]] PresetGallery* gallery() const { return m_gallery; }
    [[nodiscard]] QAction* addAction() const { return m_add; }
    [[nodiscard]] QAction* giveAction() const { return m_give; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void add(const QString& preset);
    void give(const QString& preset);
    void complain(const Error& error);
    void follow();
    void retranslate();

    Document* m_document;
    PresetGallery* m_gallery;
    QLabel* m_problem;
    QAction* m_add;
    QAction* m_give;
};

} // namespace ramure
