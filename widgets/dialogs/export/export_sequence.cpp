// What the export dialog does about sequences and pictures.
#include "core/io/formats/file_format.h"
#include "core/qt/document/document.h"
#include "core/qt/session/export/document_source.h"
#include "core/qt/session/export/exporter.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/export_task.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/picture_form.h"
#include "widgets/view/render/passes/film_file.h"
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSet>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// Of a picture with world and shadows; measured.
constexpr double bytesPerPixel = 0.85;

std::string systemPath(const QString& path)
{
    return QFile::encodeName(path).toStdString();
}

QString numbered(const QString& path, std::int64_t frame)
{
    return QFile::decodeName(numberedFile(systemPath(path), frame).c_str());
}

/// Two or three digits: nobody knows more.
QString roughSize(double bytes)
{
    const int digits = static_cast<int>(std::log10(bytes));
    return QLocale().formattedDataSize(qint64(bytes), digits > 2 && digits % 3 == 0 ? 1 : 0,
                                       QLocale::DataSizeSIFormat);
}

} // namespace

void ExportDialog::setSequenceTask(SequenceTask* task)
{
    m_sequences = task;
    updateWidgets();
}

void ExportDialog::setPictureLook(const PictureLook& look)
{
    m_look = look;
    m_pictures->setPictureSize(look.size);
    setPicturesEnabled(true);
}

/// One file that moves.
bool ExportDialog::isClip() const
{
    return holds(holdsClip) && (m_moments->moment() == ExportMoment::Sequence || m_moments->loop());
}

/// One film of many pictures.
bool ExportDialog::isFilmed() const
{
    return !format() && suffix() != pictureFormat;
}

bool ExportDialog::isNumbered() const
{
    return m_moments->isNumbered() && !isClip() && !isFilmed();
}

bool ExportDialog::isInBackground() const
{
    return !format() || isNumbered();
}

/// Names, number and size of what will be there afterwards.
void ExportDialog::updateSummary()
{
    const bool turns = m_moments->moment() == ExportMoment::Turntable;
    const FrameSequence frames = m_moments->frames();
    QStringList parts;
    std::int64_t count = turns ? m_moments->turns() : 1;
    if (m_moments->moment() == ExportMoment::Sequence || m_moments->loop())
        count = checkSequence(frames) ? frames.count() : 0;
    QString file = path();
    if (QFileInfo(file).suffix().isEmpty())
        file += u'.' + suffix();
    if ((isClip() || isFilmed()) && count > 0) {
        parts += tr("%Ln frame(s) in one file", nullptr, int(count));
        count = 1;
    } else if (count > 1) {
        const auto nameOf = [&](std::int64_t i) {
            return QFileInfo(numbered(file, turns ? i : frames.frame(i))).fileName();
        };
        parts += QStringLiteral("%1 … %2").arg(nameOf(0), nameOf(count - 1));
    } else if (count == 1 && isNumbered()) {
        parts += QFileInfo(numbered(file, frames.first)).fileName();
    }
    if (const auto files = exportFiles(format() ? options() : ExportOptions(), systemPath(file));
        files.size() > 1)
        parts += QStringLiteral("%1 … %2").arg(QFileInfo(QFile::decodeName(files.front().c_str())).fileName(),
                                               QFileInfo(QFile::decodeName(files.back().c_str())).fileName());
    const bool materials = format() && *format()->beside != '\0' && options().model != ExportModel::Skeleton;
    if (isNumbered() && !options().instances)
        parts += tr("%Ln file(s)", nullptr, int(count * (materials ? 2 : 1)));
    const QSize size = m_pictures->pictureSize();
    ExportOptions wanted = options();
    if (isClip() && checkSequence(frames))
        wanted.clip.resize(std::size_t(frames.count()) - 1);
    const double each = isFilmed() ? 0.0 // as long as it moves little, a film is small
                        : !format()
                            ? bytesPerPixel * size.width() * size.height()
                            : double(estimatedFileBytes(m_document->scene(), wanted,
                                                        documentSource(*m_document), systemPath(file)));
    if (const double bytes = each * double(count); bytes >= 1.0 && !isPrint())
        parts += tr("about %1").arg(roughSize(bytes));
    m_summary->setText(parts.join(QStringLiteral("  ·  ")));
}

/// All that can be known to go wrong before the work begins.
bool ExportDialog::mayStart()
{
    const auto refuse = [this](const QString& text) {
        setMessage(text, true);
        return false;
    };
    if (format()) {
        if (const auto known = findFormat(path().toStdString(), FormatUse::Write); !known)
            return refuse(errorText(known.error()));
    } else if (QFileInfo(path()).suffix().toLower() != suffix()) {
        return refuse(tr("Unknown file ending: .%1 is expected").arg(suffix()));
    } else if (isFilmed()) {
        if (const auto fine = canFilm(systemPath(path())); !fine)
            return refuse(errorText(fine.error()));
        if (!m_moments->isNumbered())
            return refuse(tr("A film needs a sequence of frames, or a view from all sides."));
    }
    if (m_use == ExportUse::Game)
        if (const auto fine = m_levels->check(); !fine)
            return refuse(errorText(fine.error()));
    if (isClip())
        if (const auto fine = checkSequence(m_moments->frames()); !fine)
            return refuse(errorText(fine.error()));
    if (!isInBackground())
        return true;
    if (!m_sequences || m_sequences->isRunning())
        return refuse(tr("Another sequence is still being written: its progress stands in the status bar."));
    if (m_moments->moment() == ExportMoment::Sequence)
        if (const auto fine = checkSequence(m_moments->frames()); !fine)
            return refuse(errorText(fine.error()));
    if (const QDir folder = QFileInfo(path()).dir(); !folder.exists())
        return refuse(tr("There is no folder “%1”.").arg(QDir::toNativeSeparators(folder.absolutePath())));
    return true;
}

/// Files that are there are replaced when the button is pressed a second time.
bool ExportDialog::mayReplaceFiles()
{
    QStringList names;
    QString wish = path();
    if (isFilmed()) {
        names += QFileInfo(path()).fileName();
    } else if (m_moments->moment() == ExportMoment::Turntable) {
        for (int i = 0; i < m_moments->turns(); ++i)
            names += QFileInfo(numbered(path(), i)).fileName();
    } else if (m_moments->moment() == ExportMoment::Sequence && !isClip()) {
        const FrameSequence frames = m_moments->frames();
        for (std::int64_t i = 0; i < frames.count(); ++i)
            names += QFileInfo(numbered(path(), frames.frame(i))).fileName();
    } else {
        for (const std::string& file :
             exportFiles(format() ? options() : ExportOptions(), systemPath(path())))
            names += QFileInfo(QFile::decodeName(file.c_str())).fileName();
    }
    if (isNumbered())
        wish += QStringLiteral(" %1 %2").arg(names.size()).arg(names.front());
    if (m_mayReplace.all || m_mayReplace.path == wish)
        return true;
    const QStringList there = QFileInfo(path()).dir().entryList(QDir::Files | QDir::Hidden | QDir::System);
    const QSet<QString> existing(there.begin(), there.end());
    const auto count = std::count_if(names.begin(), names.end(),
                                     [&](const QString& name) { return existing.contains(name); });
    if (count == 0)
        return true;
    m_mayReplace.path = wish;
    setMessage(isNumbered() ? tr("%Ln of these files are there already. “Replace” writes over them.", nullptr,
                                 int(count))
                            : tr("“%1” is there already. “Replace” writes over it.").arg(names.front()),
               true);
    m_export->setText(tr("Replace"));
    return false;
}

void ExportDialog::startSequence()
{
    const std::string file = systemPath(path());
    if (format()) {
        m_sequences->startMeshes(*m_document, options(), m_moments->frames(), path());
    } else {
        PictureLook look = *m_look;
        look.size = m_pictures->pictureSize();
        look.options.world = !m_pictures->isTransparent();
        look.allAround = m_moments->moment() == ExportMoment::Turntable;
        if (isFilmed()) {
            const FrameSequence range = m_moments->frames();
            look.film = file;
            look.framesPerSecond = range.framesPerSecond / double(range.step);
        }
        std::vector<PictureShot> shots;
        if (m_moments->moment() == ExportMoment::Sequence)
            shots = frameShots(m_moments->frames(), file);
        else if (m_moments->moment() == ExportMoment::Turntable)
            shots = turntableShots(m_moments->turns(), m_moments->timeSeconds(), file);
        else
            shots.push_back({m_moments->timeSeconds(), 0.0, file});
        m_sequences->startPictures(*m_document, look, std::move(shots));
    }
    keepChoices();
    emit started();
    accept();
}

} // namespace ramure
