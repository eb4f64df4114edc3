// The widgets of the export dialog, and what they say.
#include "core/io/formats/file_format.h"
#include "core/qt/document/document.h"
#include "widgets/base/fields/level_form.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/preferences.h"
#include "widgets/dialogs/export/export_dialog.h"
#include "widgets/dialogs/export/export_rows.h"
#include "widgets/dialogs/export/moment_form.h"
#include "widgets/dialogs/export/print_form.h"
#include "widgets/dialogs/export/space_form.h"
#include "widgets/dialogs/picture_form.h"
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabBar>
#include <algorithm>
#include <utility>

namespace ramure {

void ExportDialog::buildForm()
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 18, 18, 14);
    layout->setSpacing(14);
    buildUses(layout);
    // No QFormLayout: its rows that are hidden take the height of others (Qt 6.4, where some wrap their
    // text).
    m_page = new QWidget(this);
    m_form = new QGridLayout(m_page);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(14);
    m_form->setVerticalSpacing(10);
    m_form->setColumnStretch(1, 1);
    m_format = new QComboBox(this);
    m_format->setObjectName(QStringLiteral("exportFormat"));
    m_model = new QComboBox(this);
    m_model->setObjectName(QStringLiteral("exportModel"));
    fillFormats();
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
    m_levels = new LevelForm(this);
    buildWind();
    m_maps = new QComboBox(this);
    m_maps->setObjectName(QStringLiteral("exportMaps"));
    for (const int size : mapSizes)
        m_maps->addItem(QString(), size);
    m_maps->setCurrentIndex(m_maps->findData(WriteOptions().mapSize));
    m_joints = new QComboBox(this);
    m_joints->setObjectName(QStringLiteral("exportJoints"));
    for (const int limit : jointLimits)
        m_joints->addItem(QString(), limit);
    m_joints->setCurrentIndex(m_joints->findData(WriteOptions().joints));
    m_compressed = new QCheckBox(this);
    m_compressed->setObjectName(QStringLiteral("exportCompressed"));
    m_space = new SpaceForm(this);
    m_space->setSpace(m_preferences->exportSpace());
    addFormRows();
    m_scroll = new QScrollArea(this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(m_page);
    layout->addWidget(m_scroll, 1);
    buildFaults(layout);
    buildProgress(layout);
}

void ExportDialog::buildWind()
{
    m_wind = new QComboBox(this);
    m_wind->setObjectName(QStringLiteral("exportWind"));
    m_wind->addItem(QString());
    for (std::size_t i = 0; i < windProfiles().size(); ++i)
        m_wind->addItem(QString());
    m_showWind = new QPushButton(this);
    m_showWind->setObjectName(QStringLiteral("exportShowWind"));
    m_showWind->setCheckable(true);
    m_showWind->setAutoDefault(false);
    m_showWind->setEnabled(false);
    m_showWind->hide();
    const auto show = [this] { emit windShown(m_showWind->isChecked() ? wind() : WindProfile::None); };
    connect(m_showWind, &QPushButton::toggled, this, show);
    connect(m_wind, &QComboBox::currentIndexChanged, this, [this, show](int row) {
        m_showWind->setEnabled(row > 0);
        if (row == 0)
            m_showWind->setChecked(false);
        else if (m_showWind->isChecked())
            show();
    });
}

/// In the order of Row.
void ExportDialog::addFormRows()
{
    auto* scope = new QVBoxLayout;
    scope->setSpacing(6);
    scope->addWidget(m_selection);
    scope->addWidget(m_hidden);
    auto* inside = new QHBoxLayout; // of a file, beside its meshes
    inside->setSpacing(16);
    inside->addWidget(m_maps, 1);
    inside->addWidget(m_compressed);
    auto* blowing = new QHBoxLayout;
    blowing->setSpacing(8);
    blowing->addWidget(m_wind, 1);
    blowing->addWidget(m_showWind);
    const auto held = [this](QLayout* layout) {
        auto* holder = new QWidget(this);
        layout->setContentsMargins(0, 0, 0, 0);
        holder->setLayout(layout);
        return holder;
    };
    for (QWidget* field :
         {held(buildKept()), static_cast<QWidget*>(m_format), static_cast<QWidget*>(m_printing),
          static_cast<QWidget*>(m_model), held(buildParts()), static_cast<QWidget*>(m_foliage),
          static_cast<QWidget*>(m_levels), held(blowing), held(inside), static_cast<QWidget*>(m_space),
          held(scope), static_cast<QWidget*>(m_moments), static_cast<QWidget*>(m_joints),
          static_cast<QWidget*>(m_pictures), held(buildTarget())}) {
        const int row = static_cast<int>(m_rows.size());
        auto* label = new QLabel(this);                         // retranslate() fills it
        label->setMinimumHeight(m_format->sizeHint().height()); // beside the first line of its field
        m_form->addWidget(label, row, 0, Qt::AlignTop);
        m_form->addWidget(field, row, 1);
        m_rows.push_back({label, field});
    }
    m_form->setRowStretch(static_cast<int>(m_rows.size()), 1); // what is left
    QWidget* before = m_uses;
    for (QWidget* next :
         {static_cast<QWidget*>(m_kept), static_cast<QWidget*>(m_keep), static_cast<QWidget*>(m_forget),
          static_cast<QWidget*>(m_format), static_cast<QWidget*>(m_printing)})
        setTabOrder(std::exchange(before, next), next);
}

/// A page for each use.
void ExportDialog::buildUses(QVBoxLayout* layout)
{
    m_uses = new QTabBar(this);
    m_uses->setObjectName(QStringLiteral("exportUses"));
    m_uses->setExpanding(false);
    m_uses->setUsesScrollButtons(true);
    for (std::size_t i = 0; i < exportUses.size(); ++i)
        m_uses->addTab(QString());
    layout->addWidget(m_uses);
}

/// Those of the page, the usual one first.
void ExportDialog::fillFormats()
{
    const QSignalBlocker quiet(m_format);
    m_format->clear();
    for (const QString& id : formatsOf(m_use))
        m_format->addItem(QString(), id);
    retranslateFormats();
}

void ExportDialog::setUse(ExportUse use)
{
    m_uses->setCurrentIndex(static_cast<int>(use));
}

void ExportDialog::setLevels(const LevelOptions& levels)
{
    setUse(ExportUse::Game);
    m_levels->setOptions(levels);
}

void ExportDialog::offerLevels(const LevelOptions& levels)
{
    m_offered = levels;
    if (m_use == ExportUse::Game)
        m_levels->setOptions(levels);
}

void ExportDialog::offerWind()
{
    m_showWind->show();
}

void ExportDialog::takeUse(int tab)
{
    m_showWind->setChecked(false);
    m_pages[m_use] = settings();
    m_use = exportUses[static_cast<std::size_t>(tab)];
    fillFormats();
    fillKept();
    setMessage({}, false);
    {
        const QSignalBlocker once(m_printing); // the page is laid out below
        m_printing->setWanted(m_use == ExportUse::Print);
    }
    forgetPrint();
    takeFormat();
    turnPage(m_use);
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
    m_summary->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_summary->setMinimumHeight(2 * m_summary->fontMetrics().lineSpacing()); // long names take two lines
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

void ExportDialog::retranslateFormats()
{
    for (const FileFormat* format : fileFormats())
        if (const int row = m_format->findData(QString::fromLatin1(format->id)); row >= 0)
            m_format->setItemText(row, coreText(format->choice));
    if (const int row = m_format->findData(pictureFormat); row >= 0)
        m_format->setItemText(row, tr("PNG pictures of the view"));
}

void ExportDialog::retranslateMore()
{
    for (std::size_t i = 0; i < exportUses.size(); ++i) {
        const int tab = static_cast<int>(i);
        m_uses->setTabText(tab, titleOf(exportUses[i]));
        m_uses->setTabToolTip(tab, m_uses->isTabEnabled(tab)
                                       ? tipOf(exportUses[i])
                                       : tr("Pictures need a view, which this machine cannot draw"));
    }
    m_uses->setAccessibleName(tr("What the export is for"));
    m_keep->setText(tr("Keep"));
    m_forget->setText(tr("Forget"));
    m_kept->lineEdit()->setPlaceholderText(tr("kept settings, or a name for these"));
    m_kept->setToolTip(
        tr("Settings of this page that were kept under a name, or those of its last export. Where files go "
           "is not part of them."));
    m_maps->setItemText(0, tr("None"));
    for (int i = 1; i < m_maps->count(); ++i)
        m_maps->setItemText(i, tr("%1 × %1 pixels").arg(mapSizes[i]));
    m_maps->setToolTip(
        tr("Size of the pictures of bark and leaves that the program makes: inside a GLB, beside an OBJ"));
    for (int i = 0; i + 1 < m_joints->count(); ++i)
        m_joints->setItemText(i, tr("%1 at most").arg(jointLimits[i]));
    m_joints->setItemText(m_joints->count() - 1, tr("All branches"));
    m_joints->setToolTip(
        tr("Joints of each tree that moves: thin branches go with those that carry them. Engines limit how "
           "many a mesh may have; fewer cost less to play"));
    m_wind->setItemText(0, tr("None"));
    for (std::size_t i = 0; i < windProfiles().size(); ++i)
        m_wind->setItemText(static_cast<int>(i) + 1, coreText(windProfiles()[i].choice));
    m_wind->setToolTip(
        tr("Numbers of each vertex by which the shaders of an engine move the tree in the wind: the phase of "
           "its branch, how far it goes, how its leaves flutter. Of a tree at rest; Unreal gets two textures "
           "beside the file. Files of the handbook has the formulas."));
    m_showWind->setText(tr("Show"));
    m_showWind->setToolTip(tr("In the view behind this dialog, trees move as they will in that engine"));
    m_compressed->setText(tr("Compressed"));
    m_compressed->setToolTip(tr(
        "Numbers are rounded to what is still seen and packed (EXT_meshopt_compression): the file is about "
        "a fifth as large, without its pictures. For web pages and engines that read it; Blender 3.4 does "
        "not."));
    fillKept();
}

void ExportDialog::retranslate()
{
    setWindowTitle(tr("Export"));
    retranslateFormats();
    retranslateMore();
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
    m_apples->setText(tr("Fruit"));
    m_selection->setText(tr("Only what is selected"));
    m_texture->setText(tr("Texture coordinates"));
    m_texture->setToolTip(tr(
        "Where each corner lies on the bark, on the picture of a leaf or a fruit. The size of one "
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
    const QString labels[] = {tr("Settings"), tr("Format"),           tr("For print"), tr("Model"),
                              tr("Parts"),    tr("Leaves and fruit"), tr("Levels"),    tr("Wind for"),
                              tr("Pictures"), tr("Axes and unit"),    tr("Nodes"),     tr("Moment"),
                              tr("Joints"),   tr("Picture"),          tr("File")};
    for (std::size_t row = 0; row < m_rows.size(); ++row)
        m_rows[row].label->setText(labels[row]);
    m_kept->setAccessibleName(labels[KeptRow]);
    m_maps->setAccessibleName(labels[MapRow]);
    m_wind->setAccessibleName(labels[WindRow]);
    m_joints->setAccessibleName(labels[JointRow]);
    m_format->setAccessibleName(labels[FormatRow]);
    m_model->setAccessibleName(labels[ModelRow]);
    m_foliage->setAccessibleName(labels[FoliageRow]);
    m_path->setAccessibleName(labels[FileRow]);
    m_progress->setAccessibleName(tr("Progress of the export"));
    updateWidgets();
}

} // namespace ramure
