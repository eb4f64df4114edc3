#include "widgets/dialogs/export_dialog.h"

#include "core/document/document.h"
#include "core/io/formats/file_format.h"
#include "core/session/recompute.h"
#include "widgets/base/chooser.h"
#include "widgets/base/core_text.h"
#include "widgets/base/preferences.h"
#include "widgets/dialogs/export_task.h"
#include "widgets/dialogs/mesh_faults.h"
#include "widgets/dialogs/moment_form.h"
#include "widgets/dialogs/picture_form.h"
#include "widgets/dialogs/print_form.h"
#include "widgets/dialogs/space_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStandardItemModel>
#include <QStyle>

namespace ramure {

/// What stands behind the formats of the table: pictures of the view.
static const QString pictureFormat = QStringLiteral("png");

/// Rows of the form, from the top.
enum Row {
    FormatRow,
    PrintRow,
    ModelRow,
    PartsRow,
    FoliageRow,
    SpaceRow,
    TreesRow,
    MomentRow,
    PictureRow,
    FileRow
};

ExportDialog::ExportDialog(Document* document, Recompute* recompute, Preferences* preferences,
                           Chooser* chooser, QWidget* parent, std::int64_t shownFrame)
    : QDialog(parent)
    , m_document(document)
    , m_recompute(recompute)
    , m_preferences(preferences)
    , m_chooser(chooser)
    , m_task(new ExportTask(this))
    , m_shownFrame(shownFrame)
{
    setObjectName(QStringLiteral("exportDialog"));
    buildForm();
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::takeFormat);
    connect(m_model, &QComboBox::currentIndexChanged, this, &ExportDialog::updateWidgets);
    for (QCheckBox* box : {m_branches, m_leaves, m_apples})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::updateWidgets);
    connect(m_foliage, &QComboBox::currentIndexChanged, this, [this](int row) {
        // Nothing is mixed into the one mesh of a format without objects.
        if (format() && !holds(holdsObjects))
            for (QCheckBox* box : {m_leaves, m_apples})
                box->setChecked(row == 1);
        updateWidgets();
    });
    connect(m_path, &QLineEdit::textChanged, this, &ExportDialog::updateWidgets);
    connect(m_moments, &MomentForm::changed, this, &ExportDialog::updateWidgets);
    connect(m_pictures, &PictureForm::changed, this, &ExportDialog::updateSummary);
    connect(m_space, &SpaceForm::changed, this, &ExportDialog::updateSummary);
    for (QCheckBox* box : {m_selection, m_hidden, m_texture})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::updateSummary);
    connectMessage();
    connect(m_printing, &PrintForm::changed, this, &ExportDialog::takePrint);
    connect(m_printing, &PrintForm::prepareRequested, this, [this] { startPrint({}); });
    for (QCheckBox* box : {m_selection, m_hidden})
        connect(box, &QCheckBox::toggled, this, &ExportDialog::forgetPrint);
    connect(m_browse, &QPushButton::clicked, this, &ExportDialog::browse);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::startExport);
    connect(m_cancel, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(m_task, &ExportTask::progress, this, [this](double fraction) {
        m_progress->setValue(static_cast<int>(fraction * m_progress->maximum()));
    });
    connect(m_task, &ExportTask::finished, this, &ExportDialog::finish);
    connect(m_recompute, &Recompute::busyChanged, this, [this](bool busy) {
        if (m_waiting && !busy)
            run();
    });
    const auto& nodes = document->scene().nodes();
    QString name = QFileInfo(document->filePath()).completeBaseName();
    if (name.isEmpty())
        name = nodes.empty() ? QStringLiteral("tree") : QString::fromStdString(nodes.front().name);
    m_path->setText(
        QDir::toNativeSeparators(QDir(preferences->lastFolder()).filePath(name + QStringLiteral(".obj"))));
    setPicturesEnabled(false);
    retranslate();
    takeFormat();
}

ExportDialog::~ExportDialog() = default;

/// What was wrong with the last attempt says nothing about the next one.
void ExportDialog::connectMessage()
{
    const auto forget = [this] { setMessage({}, false); };
    for (QComboBox* box : {m_format, m_model, m_foliage})
        connect(box, &QComboBox::currentIndexChanged, this, forget);
    for (QCheckBox* box : {m_branches, m_leaves, m_apples, m_selection, m_hidden, m_texture})
        connect(box, &QCheckBox::toggled, this, forget);
    connect(m_path, &QLineEdit::textChanged, this, forget);
    connect(m_space, &SpaceForm::changed, this, forget);
    connect(m_moments, &MomentForm::changed, this, forget);
    connect(m_pictures, &PictureForm::changed, this, forget);
    connect(m_printing, &PrintForm::changed, this, forget);
}

void ExportDialog::buildForm()
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 18, 18, 14);
    layout->setSpacing(14);
    m_form = new QFormLayout;
    m_form->setHorizontalSpacing(14);
    m_form->setVerticalSpacing(10);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    // An empty text would make no label: retranslate() fills it.
    const auto addRow = [this](auto* field) { m_form->addRow(new QLabel(this), field); };
    m_format = new QComboBox(this);
    m_model = new QComboBox(this);
    for (const FileFormat* format : fileFormats())
        if (isFor(*format, FormatUse::Write))
            m_format->addItem(QString(), QString::fromLatin1(format->id));
    m_format->addItem(QString(), pictureFormat);
    for (int i = 0; i < 3; ++i)
        m_model->addItem(QString());
    m_foliage = new QComboBox(this);
    m_foliage->setObjectName(QStringLiteral("exportFoliage"));
    m_foliage->addItems({QString(), QString()});
    m_moments = new MomentForm(m_document->scene().timeline(), m_shownFrame, this);
    m_pictures = new PictureForm(this);
    m_printing = new PrintForm(this);
    m_selection = new QCheckBox(this);
    m_selection->setEnabled(!m_document->selection().nodes.empty());
    m_hidden = new QCheckBox(this);
    auto* scope = new QVBoxLayout;
    scope->setSpacing(6);
    scope->addWidget(m_selection);
    scope->addWidget(m_hidden);
    addRow(m_format);
    addRow(m_printing);
    addRow(m_model);
    m_space = new SpaceForm(this);
    m_space->setSpace(m_preferences->exportSpace());
    addRow(buildParts());
    addRow(m_foliage);
    addRow(m_space);
    addRow(scope);
    addRow(m_moments);
    addRow(m_pictures);
    addRow(buildTarget());
    setTabOrder(m_format, m_printing);
    layout->addLayout(m_form);
    buildFaults(layout);
    buildProgress(layout);
}

QLayout* ExportDialog::buildParts()
{
    m_branches = new QCheckBox(this);
    m_leaves = new QCheckBox(this);
    m_apples = new QCheckBox(this);
    auto* boxes = new QHBoxLayout;
    boxes->setSpacing(16);
    for (QCheckBox* box : {m_branches, m_leaves, m_apples}) {
        box->setChecked(true);
        boxes->addWidget(box);
    }
    m_texture = new QCheckBox(this);
    m_texture->setObjectName(QStringLiteral("exportTexture"));
    m_texture->setChecked(true);
    boxes->addWidget(m_texture);
    boxes->addStretch(1);
    m_partsNote = new QLabel(this);
    m_partsNote->setObjectName(QStringLiteral("partsNote"));
    m_partsNote->setTextFormat(Qt::PlainText);
    m_partsNote->setWordWrap(true);
    auto* parts = new QVBoxLayout;
    parts->setSpacing(6);
    parts->addLayout(boxes);
    parts->addWidget(m_partsNote);
    return parts;
}

/// The file, and below it what that will come to.
QLayout* ExportDialog::buildTarget()
{
    m_path = new QLineEdit(this);
    m_path->setMinimumWidth(320);
    m_browse = new QPushButton(this);
    m_summary = new QLabel(this);
    m_summary->setObjectName(QStringLiteral("dim"));
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setWordWrap(true);
    auto* file = new QHBoxLayout;
    file->setSpacing(8);
    file->addWidget(m_path, 1);
    file->addWidget(m_browse);
    auto* target = new QVBoxLayout;
    target->setSpacing(6);
    target->addLayout(file);
    target->addWidget(m_summary);
    return target;
}

/// What is not clean about the mesh, and the way to it.
void ExportDialog::buildFaults(QVBoxLayout* layout)
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    m_faults = new QLabel(this);
    m_faults->setObjectName(QStringLiteral("meshFaults"));
    m_faults->setTextFormat(Qt::PlainText);
    m_faults->setWordWrap(true);
    m_show = new QPushButton(this);
    m_show->setObjectName(QStringLiteral("showFaults"));
    m_show->setAutoDefault(false);
    row->addWidget(m_faults, 1);
    row->addWidget(m_show, 0, Qt::AlignTop);
    layout->addLayout(row);
    connect(m_show, &QPushButton::clicked, this, [this] {
        const NodeId tree = meshFaults(*m_document, m_analysis, options()).tree;
        reject();
        emit showRequested(tree);
    });
}

void ExportDialog::setAnalysis(const Analysis* analysis)
{
    m_analysis = analysis;
    if (m_analysis)
        connect(m_analysis, &Analysis::changed, this, &ExportDialog::showFaults);
    showFaults();
}

void ExportDialog::showFaults()
{
    const MeshFaults found =
        format() && !isPrint() ? meshFaults(*m_document, m_analysis, options()) : MeshFaults();
    const QString& text = found.text;
    m_faults->setText(text);
    m_faults->setProperty("broken", found.mustAsk());
    m_faults->style()->unpolish(m_faults);
    m_faults->style()->polish(m_faults);
    m_faults->setVisible(!text.isEmpty());
    m_show->setVisible(!text.isEmpty());
    const bool accepted = !text.isEmpty() && text == m_acceptedFaults;
    m_export->setText(accepted ? tr("Export anyway") : tr("Export"));
}

/// A broken mesh is written when the button is pressed a second time.
bool ExportDialog::mayExportFaults()
{
    const MeshFaults found =
        format() && !isPrint() ? meshFaults(*m_document, m_analysis, options()) : MeshFaults();
    if (!found.mustAsk() || found.text == m_acceptedFaults)
        return true;
    m_acceptedFaults = found.text;
    showFaults();
    setMessage(tr("Export it all the same?"), false);
    return false;
}

/// What is below the form: the message, the bar, the buttons.
void ExportDialog::buildProgress(QVBoxLayout* layout)
{
    m_message = new QLabel(this);
    m_message->setWordWrap(true);
    m_message->hide();
    layout->addWidget(m_message);
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    QSizePolicy policy = m_progress->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(policy);
    m_progress->hide();
    layout->addWidget(m_progress);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    m_export = new QPushButton(this);
    m_export->setDefault(true);
    m_cancel = new QPushButton(this);
    m_cancel->setAutoDefault(false);
    m_browse->setAutoDefault(false);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_export);
    layout->addLayout(buttons);
}

const FileFormat* ExportDialog::format() const
{
    const QString id = m_format->currentData().toString();
    for (const FileFormat* format : fileFormats())
        if (id == QLatin1String(format->id))
            return format;
    return nullptr;
}

bool ExportDialog::holds(int what) const
{
    return format() && (format()->holds & what);
}

QString ExportDialog::suffix() const
{
    return format() ? QString::fromLatin1(format()->ending) : pictureFormat;
}

void ExportDialog::setFormat(const QString& id)
{
    m_format->setCurrentIndex(m_format->findData(id));
}

void ExportDialog::setPicturesEnabled(bool enabled)
{
    qobject_cast<QStandardItemModel*>(m_format->model())
        ->item(m_format->findData(pictureFormat))
        ->setEnabled(enabled);
}

void ExportDialog::setPath(const QString& path)
{
    m_path->setText(QDir::toNativeSeparators(path));
}

QString ExportDialog::path() const
{
    return QDir::fromNativeSeparators(m_path->text().trimmed());
}

ExportOptions ExportDialog::options() const
{
    ExportOptions options;
    options.model = static_cast<ExportModel>(m_model->currentIndex());
    options.parts = static_cast<std::uint8_t>((m_branches->isChecked() ? exportBranches : 0) |
                                              (m_leaves->isChecked() ? exportLeaves : 0) |
                                              (m_apples->isChecked() ? exportApples : 0));
    if (m_selection->isChecked())
        options.nodes = m_document->selection().nodes;
    options.hidden = m_hidden->isChecked();
    options.instances = m_foliage->currentIndex() == 1;
    options.texture = options.model == ExportModel::Mesh && holds(holdsTexture) && m_texture->isChecked();
    options.write.ascii = format() && format()->isText;
    if (holds(holdsSpace))
        options.space = m_space->space();
    return options;
}

void ExportDialog::takeFormat()
{
    const bool all = !format() || usualParts(*format(), m_foliage->currentIndex() == 1) == exportAll;
    m_leaves->setChecked(all);
    m_apples->setChecked(all);
    const QFileInfo info(path());
    if (info.suffix().toLower() == pictureFormat || findFormat(path().toStdString(), FormatUse::Write))
        setPath(info.path() + u'/' + info.completeBaseName() + u'.' + suffix());
    for (const Row row : {PrintRow, ModelRow, PartsRow, FoliageRow, TreesRow, MomentRow})
        m_form->setRowVisible(row, format() != nullptr || row == MomentRow);
    m_form->setRowVisible(SpaceRow, holds(holdsSpace));
    showPrintRows({ModelRow, PartsRow, FoliageRow, SpaceRow, MomentRow});
    m_form->setRowVisible(PictureRow, !format());
    m_moments->setPictures(!format());
    // A picture shows what the view shows.
    if (!format() && m_shownFrame > 0 && m_moments->moment() == ExportMoment::Rest)
        m_moments->setMoment(ExportMoment::Shown);
    updateWidgets();
    adjustSize();
}

void ExportDialog::updateWidgets()
{
    const bool running = m_waiting || m_task->isRunning();
    const bool lines = static_cast<ExportModel>(m_model->currentIndex()) == ExportModel::Skeleton;
    for (QWidget* widget :
         {static_cast<QWidget*>(m_format), static_cast<QWidget*>(m_model), static_cast<QWidget*>(m_path),
          static_cast<QWidget*>(m_browse), static_cast<QWidget*>(m_hidden)})
        widget->setEnabled(!running);
    for (QCheckBox* box : {m_branches, m_leaves, m_apples})
        box->setEnabled(!running && !lines);
    m_foliage->setEnabled(!running && !lines);
    if (format())
        m_partsNote->setText(tr("%1 has no objects: leaves and apples would be mixed into the one closed "
                                "mesh of the branches. Tick them to write them all the same.")
                                 .arg(coreText(format()->name)));
    m_partsNote->setVisible(format() && !isPrint() && !holds(holdsObjects) && !lines &&
                            !options().instances && !(m_leaves->isChecked() && m_apples->isChecked()));
    m_texture->setEnabled(!running && holds(holdsTexture) &&
                          static_cast<ExportModel>(m_model->currentIndex()) == ExportModel::Mesh);
    m_space->setEnabled(!running);
    m_printing->setEnabled(!running && !m_recompute->isBusy());
    m_moments->setEnabled(!running);
    m_pictures->setEnabled(!running);
    m_selection->setEnabled(!running && !m_document->selection().nodes.empty());
    m_export->setEnabled(!running && !path().isEmpty() && (lines || options().parts != 0));
    m_progress->setVisible(running);
    updateSummary();
    showFaults();
}

void ExportDialog::browse()
{
    const QString filter =
        (format() ? coreText(format()->name) : tr("PNG pictures")) + QStringLiteral(" (*.%1)").arg(suffix());
    const QString chosen = m_chooser->saveFile(tr("Export"), path(), filter, suffix());
    if (chosen.isEmpty())
        return;
    setPath(chosen);
    if (!isNumbered())
        m_mayReplace = path(); // the chooser has asked
}

void ExportDialog::startExport()
{
    if (QFileInfo(path()).suffix().isEmpty())
        setPath(path() + u'.' + suffix());
    if (!mayStart() || !mayReplaceFiles())
        return;
    m_progress->setValue(0);
    if (!m_recompute->isBusy() && !mayExportFaults())
        return;
    if (m_recompute->isBusy()) {
        m_waiting = true;
        setMessage(tr("Waiting until the tree is computed…"), false);
        updateWidgets();
        return;
    }
    run();
}

void ExportDialog::run()
{
    m_waiting = false;
    if (!mayExportFaults()) // they came with the result that was waited for
        return updateWidgets();
    setMessage({}, false);
    if (isPrint())
        return startPrint(path());
    if (isInBackground())
        return startSequence();
    ExportOptions what = options();
    double seconds = m_moments->timeSeconds();
    if (isClip()) {
        const FrameSequence frames = m_moments->frames();
        seconds = frames.timeOf(frames.first);
        for (std::int64_t i = 1; i < frames.count(); ++i)
            what.clip.push_back(frames.timeOf(frames.frame(i)));
    }
    m_task->startExport(*m_document, what, path(), seconds);
    updateWidgets();
}

void ExportDialog::finish(const std::optional<Error>& error)
{
    updateWidgets();
    if (hasPrepared(error))
        return;
    if (error && error->code == ErrorCode::Cancelled) {
        setMessage(tr("Cancelled. No file was changed."), false);
        return;
    }
    if (error) {
        setMessage(errorTextWithPlace(*error), true);
        // While it ran everything but "Cancel" was off and took no focus: Return is to try again, not to
        // leave.
        m_path->setFocus();
        return;
    }
    keepChoices();
    emit exported(path());
    accept();
}

/// For the next export.
void ExportDialog::keepChoices()
{
    m_preferences->setLastFolder(QFileInfo(path()).absolutePath());
    m_preferences->setExportSpace(m_space->space());
}

void ExportDialog::setMessage(const QString& text, bool isError)
{
    m_message->setObjectName(isError ? QStringLiteral("problem") : QStringLiteral("hint"));
    m_message->style()->unpolish(m_message);
    m_message->style()->polish(m_message);
    m_message->setText(text);
    m_message->setVisible(!text.isEmpty());
}

void ExportDialog::reject()
{
    if (m_waiting) {
        m_waiting = false;
        setMessage(tr("Cancelled. No file was changed."), false);
        updateWidgets();
    } else if (m_task->isRunning()) {
        m_task->cancel();
    } else {
        QDialog::reject();
    }
}

void ExportDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void ExportDialog::retranslate()
{
    setWindowTitle(tr("Export"));
    for (const FileFormat* format : fileFormats())
        if (const int row = m_format->findData(QString::fromLatin1(format->id)); row >= 0)
            m_format->setItemText(row, coreText(format->choice));
    m_format->setItemText(m_format->findData(pictureFormat), tr("PNG pictures of the view"));
    m_model->setItemText(static_cast<int>(ExportModel::Mesh), tr("Finished mesh"));
    m_model->setItemText(static_cast<int>(ExportModel::Rough), tr("Rough model"));
    m_model->setItemText(static_cast<int>(ExportModel::Skeleton), tr("Skeleton as lines"));
    m_foliage->setItemText(0, tr("Merged into one mesh"));
    m_foliage->setItemText(1, tr("List of instances"));
    m_foliage->setToolTip(tr(
        "Merged: the file holds every leaf and every fruit. List of instances: it holds the rest, and beside "
        "it stand a table, FILE_leaves.csv, with a row for each leaf, fruit and flower (its shape, material, "
        "branch, colour and matrix), and one OBJ for each shape; in a GLB they stand inside. Much smaller, "
        "for programs that draw instances."));
    m_branches->setText(tr("Branches"));
    m_leaves->setText(tr("Leaves"));
    m_apples->setText(tr("Apples"));
    m_selection->setText(tr("Only what is selected"));
    m_texture->setText(tr("Texture coordinates"));
    m_texture->setToolTip(tr(
        "Where each corner lies on the bark, on the picture of a leaf or an apple. The size of one "
        "repeat of the bark, in metres, is the tree's parameter \"Bark tile\". Beside an .obj, the pictures "
        "of the bark are written too."));
    const QString whole =
        tr("Trees, arms as they are at the moment, terrains, primitives and imported meshes "
           "are written where they stand in the world, each under a name of its own.");
    m_selection->setToolTip(whole);
    m_hidden->setToolTip(whole);
    m_hidden->setText(tr("Hidden nodes too"));
    m_browse->setText(tr("Browse…"));
    m_show->setText(tr("Show"));
    m_cancel->setText(tr("Cancel"));
    const QString labels[] = {tr("Format"),           tr("For print"),     tr("Model"), tr("Parts"),
                              tr("Leaves and fruit"), tr("Axes and unit"), tr("Nodes"), tr("Moment"),
                              tr("Picture"),          tr("File")};
    for (int row = 0; row < m_form->rowCount(); ++row) {
        auto* label = qobject_cast<QLabel*>(m_form->itemAt(row, QFormLayout::LabelRole)->widget());
        label->setText(labels[row]);
    }
    m_format->setAccessibleName(labels[0]);
    m_model->setAccessibleName(labels[ModelRow]);
    m_foliage->setAccessibleName(labels[FoliageRow]);
    m_path->setAccessibleName(labels[FileRow]);
    m_progress->setAccessibleName(tr("Progress of the export"));
    updateWidgets();
}

} // namespace ramure
