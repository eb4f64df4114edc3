#include "widgets/panels/presets/gallery_panel.h"

#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/params/presets.h"
#include "core/session/planting.h"
#include "widgets/base/core_text.h"
#include "widgets/base/targets.h"
#include "widgets/panels/presets/picture_button.h"
#include "widgets/panels/presets/preset_gallery.h"
#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace ramure {
namespace {

/// What a species is, without where a tree stands and what holds it.
bool isOfSpecies(const ParamDef& def)
{
    const std::string_view key = def.key;
    return hasParam(NodeKind::Tree, def) && def.stage != Stage::Placement && !key.starts_with("tree.") &&
           !key.starts_with("local.") && !key.starts_with("physics.");
}

} // namespace

GalleryPanel::GalleryPanel(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_gallery(new PresetGallery(PictureButton::smallWidth, this))
    , m_problem(new QLabel(this))
    , m_add(new QAction(this))
    , m_give(new QAction(this))
{
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setWordWrap(true);
    m_problem->hide();
    auto* content = new QWidget;
    auto* inside = new QVBoxLayout(content);
    inside->setContentsMargins(8, 8, 8, 8);
    inside->addWidget(m_gallery);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(content);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_problem);
    layout->addWidget(scroll, 1);
    m_gallery->addChoice(m_add);
    m_gallery->addChoice(m_give);
    connect(m_gallery, &PresetGallery::chosen, this, &GalleryPanel::add);
    connect(m_add, &QAction::triggered, this, [this] { add(m_gallery->menuPreset()); });
    connect(m_give, &QAction::triggered, this, [this] { give(m_gallery->menuPreset()); });
    connect(m_document, &Document::changed, this, &GalleryPanel::follow);
    retranslate();
    follow();
}

QSize GalleryPanel::sizeHint() const
{
    return {300, 260};
}

void GalleryPanel::add(const QString& preset)
{
    if (const auto planted = edit::plantTree(*m_document, preset.toStdString()); !planted)
        complain(planted.error());
}

void GalleryPanel::give(const QString& preset)
{
    const auto params = presetParams(preset.toStdString());
    if (!params)
        return complain(params.error());
    std::vector<std::pair<const ParamDef*, ParamValue>> values;
    for (const ParamDef& def : paramTable())
        if (isOfSpecies(def))
            values.emplace_back(&def, def.get(*params));
    const QString text = tr("Make it %1", "undo step; the name of a preset").arg(spacedName(preset));
    if (const auto given = edit::setParams(*m_document, targetTrees(*m_document), values, text); !given)
        complain(given.error());
}

void GalleryPanel::complain(const Error& error)
{
    m_problem->setText(errorText(error));
    m_problem->show();
}

void GalleryPanel::follow()
{
    m_problem->hide();
    m_give->setEnabled(!targetTrees(*m_document).empty());
}

void GalleryPanel::retranslate()
{
    m_add->setText(tr("&Add to the scene"));
    m_give->setText(tr("&Give its numbers to the selected trees"));
}

void GalleryPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace ramure
