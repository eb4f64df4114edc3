#include "widgets/panels/properties/picture_editor.h"

#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/view/render/surface_images.h"
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QToolButton>

namespace ramure {
namespace {

constexpr int thumbnailSide = 40; ///< of the thumbnail, device-independent pixels

QString pathOf(const ParamValue& value)
{
    return QFile::decodeName(std::get<std::string>(value).c_str());
}

} // namespace

QString draggedPicture(const QMimeData& data)
{
    const QList<QUrl> urls = data.hasUrls() ? data.urls() : QList<QUrl>();
    if (urls.size() != 1 || !urls.front().isLocalFile())
        return {};
    const QString path = urls.front().toLocalFile();
    const QString ending = QFileInfo(path).suffix().toLower();
    return QStringList{QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg")}.contains(ending)
               ? path
               : QString();
}

PictureEditor::PictureEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
    , m_button(named(new QToolButton(this), "pictureButton"))
    , m_file(new QLineEdit(this))
{
    setAcceptDrops(true);
    auto* layout = layoutOf<QHBoxLayout>(this, 6);
    layout->addWidget(m_button);
    layout->addWidget(m_file, 1);
    m_button->setFixedSize(thumbnailSide + 8, thumbnailSide + 8);
    m_button->setIconSize({thumbnailSide, thumbnailSide});
    m_button->setFocusPolicy(Qt::StrongFocus);
    m_file->setMinimumWidth(20);   // cut off rather than that the panel grows
    m_file->setAcceptDrops(false); // it would take the address as a text
    m_button->setToolTip(tr("Choose a picture, or drop one here"));
    m_button->setAccessibleName(tr("%1: choose").arg(name()));
    m_file->setAccessibleName(name());
    setFocusProxy(m_button);
    connect(m_button, &QToolButton::clicked, this, &PictureEditor::choose);
    connect(m_file, &QLineEdit::editingFinished, this, [this] {
        if (m_file->isModified())
            emitSingleEdit(QFile::encodeName(m_file->text().trimmed()).toStdString());
        m_file->setModified(false);
    });
    showImage();
}

void PictureEditor::showValues(std::span<const ParamValue> values)
{
    const auto value = commonValue(values);
    m_path = value ? pathOf(*value) : QString();
    if (!m_file->isModified()) { // what is being typed stays
        m_file->setText(QDir::toNativeSeparators(m_path));
        m_file->setPlaceholderText(value ? tr("None") : QStringLiteral("—"));
    }
    m_file->setToolTip(m_file->text());
    read();
}

/// Also one that has the same name as before may be another one by now.
void PictureEditor::read()
{
    emit refused(QString());
    if (m_path.isEmpty()) {
        m_job.forget();
        m_image = {};
        return showImage();
    }
    const int pixels = static_cast<int>(thumbnailSide * devicePixelRatioF());
    m_job.start([path = QFile::encodeName(m_path).toStdString(),
                 pixels](const Progress&) { return readPicture(path, pixels); },
                [this](Expected<QImage>&& made) {
                    m_image = made ? std::move(*made) : QImage();
                    if (!made)
                        emit refused(errorText(made.error()));
                    showImage();
                });
}

void PictureEditor::showImage()
{
    if (m_image.isNull())
        m_button->setIcon(icon(m_path.isEmpty() ? "open" : "warning"));
    else
        m_button->setIcon(QPixmap::fromImage(m_image));
    m_button->setIconSize(m_image.isNull() ? QSize(16, 16) : QSize(thumbnailSide, thumbnailSide));
}

void PictureEditor::choose()
{
    if (m_dialog) {
        m_dialog->raise();
        m_dialog->activateWindow();
        return;
    }
    const QString folder = m_path.isEmpty() ? QString() : QFileInfo(m_path).absolutePath();
    m_dialog = new QFileDialog(window(), name(), folder, tr("Pictures (*.png *.jpg *.jpeg)"));
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_dialog->setFileMode(QFileDialog::ExistingFile);
    connect(m_dialog, &QFileDialog::fileSelected, this,
            [this](const QString& path) { emitSingleEdit(QFile::encodeName(path).toStdString()); });
    connect(m_dialog, &QObject::destroyed, this, [this] { m_dialog = nullptr; });
    m_dialog->open();
}

void PictureEditor::dragEnterEvent(QDragEnterEvent* event)
{
    if (draggedPicture(*event->mimeData()).isEmpty())
        return; // the window may open it
    m_button->setDown(true);
    event->acceptProposedAction();
}

void PictureEditor::dragLeaveEvent(QDragLeaveEvent*)
{
    m_button->setDown(false);
}

void PictureEditor::dropEvent(QDropEvent* event)
{
    m_button->setDown(false);
    const QString path = draggedPicture(*event->mimeData());
    if (path.isEmpty())
        return;
    event->acceptProposedAction();
    emitSingleEdit(QFile::encodeName(path).toStdString());
}

} // namespace ramure
