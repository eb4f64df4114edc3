/// \file
/// An image file: its thumbnail, which opens a file dialog and takes pictures that are dropped on it, and its
/// path.
#pragma once

#include "core/qt/session/jobs/job.h"
#include "widgets/panels/properties/param_editor.h"
#include <QImage>

class QFileDialog;
class QLineEdit;
class QMimeData;
class QToolButton;

namespace ramure {

/// The path of the one PNG or JPEG file that is dragged; empty: there is none.
QString draggedPicture(const QMimeData& data);

class PictureEditor : public ParamEditor
{
    Q_OBJECT
public:
    PictureEditor(const ParamDef& def, QWidget* parent);

    void showValues(std::span<const ParamValue> values) override;
    /// Null while it is read, where there is none, and where it cannot be read.
    [[nodiscard]] const QImage& thumbnail() const { return m_image; }
    [[nodiscard]] QToolButton* button() const { return m_button; }

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void choose();
    void read();
    void showImage();

    QToolButton* m_button = nullptr; ///< has the thumbnail
    QLineEdit* m_file = nullptr;
    QFileDialog* m_dialog = nullptr; ///< while it is open
    QString m_path;                  ///< empty: none, or several
    QImage m_image;
    Job m_job;
};

} // namespace ramure
