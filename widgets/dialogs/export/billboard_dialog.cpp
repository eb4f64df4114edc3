#include "widgets/dialogs/export/billboard_dialog.h"

#include "widgets/base/named.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace ramure {

static constexpr int leastOfferedSize = 256;
static_assert(leastOfferedSize >= leastBillboardSize);

BillboardDialog::BillboardDialog(bool hasSelection, const QVariantMap& kept, QWidget* parent)
    : QDialog(parent)
    , m_form(new QFormLayout)
    , m_kind(named(new QComboBox(this), "billboardKind"))
    , m_cards(named(new QSpinBox(this), "billboardCards"))
    , m_lying(named(new QCheckBox(this), "billboardLying"))
    , m_views(named(new QSpinBox(this), "billboardViews"))
    , m_size(named(new QComboBox(this), "billboardSize"))
    , m_files(named(new QComboBox(this), "billboardFiles"))
    , m_selection(named(new QCheckBox(this), "billboardSelection"))
    , m_summary(named(new QLabel(this), "dim"))
    , m_problem(named(new QLabel(this), "problem"))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this))
{
    setObjectName(QStringLiteral("billboardDialog"));
    m_kind->addItems({QString(), QString()});
    m_files->addItems({QString(), QString()});
    m_cards->setRange(leastCards, mostCards);
    m_views->setRange(leastViews, mostViews);
    for (int size = leastOfferedSize; size <= mostBillboardSize; size *= 2)
        m_size->addItem(QStringLiteral("%1 px").arg(size), size);
    m_selection->setEnabled(hasSelection);
    build();
    take(kept);
    for (QComboBox* box : {m_kind, m_size, m_files})
        connect(box, &QComboBox::currentIndexChanged, this, &BillboardDialog::follow);
    for (QSpinBox* box : {m_cards, m_views})
        connect(box, &QSpinBox::valueChanged, this, &BillboardDialog::follow);
    connect(m_lying, &QCheckBox::toggled, this, &BillboardDialog::follow);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setTexts();
    follow();
}

void BillboardDialog::build()
{
    for (QWidget* field :
         {static_cast<QWidget*>(m_kind), static_cast<QWidget*>(m_cards), static_cast<QWidget*>(m_lying),
          static_cast<QWidget*>(m_views), static_cast<QWidget*>(m_size), static_cast<QWidget*>(m_files),
          static_cast<QWidget*>(m_selection)}) {
        auto* label = new QLabel(this); // setTexts() fills it
        label->setBuddy(field);
        m_form->addRow(label, field);
    }
    for (QLabel* line : {m_summary, m_problem}) {
        line->setTextFormat(Qt::PlainText);
        line->setWordWrap(true);
        line->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        line->setMinimumWidth(360);
        line->setMinimumHeight(2 * line->fontMetrics().lineSpacing());
    }
    auto* layout = layoutOf<QVBoxLayout>(this, 10, {18, 18, 18, 14});
    layout->setSizeConstraint(QLayout::SetFixedSize);
    layout->addLayout(m_form);
    layout->addWidget(m_summary);
    layout->addWidget(m_problem);
    layout->addWidget(m_buttons);
}

void BillboardDialog::take(const QVariantMap& kept)
{
    const BillboardWish usual;
    const auto number = [&kept](const char* key, int otherwise) {
        return kept.value(QLatin1String(key), otherwise).toInt();
    };
    m_kind->setCurrentIndex(kept.value(QStringLiteral("atlas")).toBool() ? 1 : 0);
    m_cards->setValue(number("cards", usual.cards));
    m_lying->setChecked(kept.value(QStringLiteral("lying")).toBool());
    m_views->setValue(number("views", usual.views));
    const int size = m_size->findData(number("size", usual.size));
    m_size->setCurrentIndex(size >= 0 ? size : m_size->findData(usual.size));
    m_files->setCurrentIndex(kept.value(QStringLiteral("folder")).toBool() ? 1 : 0);
    m_selection->setChecked(m_selection->isEnabled() && kept.value(QStringLiteral("selection")).toBool());
}

BillboardWish BillboardDialog::wish() const
{
    return {m_kind->currentIndex() == 1, m_size->currentData().toInt(), m_cards->value(),
            m_lying->isChecked(), m_views->value()};
}

bool BillboardDialog::isFolder() const
{
    return wish().isAtlas || m_files->currentIndex() == 1;
}

bool BillboardDialog::isSelectionOnly() const
{
    return m_selection->isChecked();
}

QVariantMap BillboardDialog::settings() const
{
    const BillboardWish now = wish();
    return {{"atlas", now.isAtlas},
            {"size", now.size},
            {"cards", now.cards},
            {"lying", now.lying},
            {"views", now.views},
            {"folder", m_files->currentIndex() == 1},
            {"selection", isSelectionOnly()}};
}

/// What the kind does not have is not shown.
void BillboardDialog::follow()
{
    const bool isAtlas = wish().isAtlas;
    for (QWidget* field :
         {static_cast<QWidget*>(m_cards), static_cast<QWidget*>(m_lying), static_cast<QWidget*>(m_files)})
        m_form->setRowVisible(field, !isAtlas);
    m_form->setRowVisible(m_views, isAtlas);
    updateMessage();
}

/// What comes of it, or why nothing can.
void BillboardDialog::updateMessage()
{
    const BillboardWish now = wish();
    const bool fits = !now.isAtlas || holdsViews(now.size, now.views);
    if (!now.isAtlas) {
        m_summary->setText(tr("%1 triangles with one picture of their colours and one of their normals.")
                               .arg(2 * (now.cards + (now.lying ? 1 : 0))));
    } else if (fits) {
        m_summary->setText(tr("%1 views of %2 px each: two PNG pictures and atlas.json, in a folder.")
                               .arg(now.views * now.views)
                               .arg(now.size / now.views));
    } else {
        QStringList fitting;
        for (int views = leastViews; views <= mostViews; ++views)
            if (holdsViews(now.size, views))
                fitting += QString::number(views);
        m_problem->setText((now.size % now.views != 0
                                ? tr("%1 px are not a multiple of %2 views.").arg(now.size).arg(now.views)
                                : tr("A view would have %1 px a side; at least %2 px are needed.")
                                      .arg(now.size / now.views)
                                      .arg(leastViewSize)) +
                           u' ' +
                           tr("Numbers of views that fit: %1.").arg(fitting.join(QStringLiteral(", "))));
    }
    m_summary->setVisible(fits);
    m_problem->setVisible(!fits);
    m_buttons->button(QDialogButtonBox::Save)->setEnabled(fits);
}

void BillboardDialog::setTexts()
{
    setWindowTitle(tr("Billboard"));
    const auto describe = [this](QWidget* field, const QString& name, const QString& tip) {
        auto* label = qobject_cast<QLabel*>(m_form->labelForField(field));
        label->setText(name);
        label->setToolTip(tip);
        field->setToolTip(tip);
    };
    describe(m_kind, tr("Kind"),
             tr("What stands for trees that are far away.\nCards: upright rectangles through the middle, for "
                "any program. Atlas: pictures from all around and above, for impostors of game engines"));
    describe(m_cards, tr("Cards"), tr("How many stand, 1 to 16, evenly turned; two triangles each"));
    describe(m_lying, QString(), tr("A card that is seen from above"));
    describe(
        m_views, tr("Views each way"),
        tr("Views in a row and in a column, 2 to 32. The size has to be a multiple of this number, with at "
           "least 16 px for each view"));
    describe(m_size, tr("Size"), tr("Width and height of the pictures in pixels"));
    describe(m_files, tr("Files"), tr("A folder gets cards.glb, cards_colour.png and cards_normal.png"));
    describe(m_selection, tr("Trees"),
             tr("Draws the selected nodes and their children. If off, draws everything visible, as it is at "
                "the time shown"));
    m_kind->setItemText(0, tr("Crossed cards"));
    m_kind->setItemText(1, tr("Atlas of views"));
    m_lying->setText(tr("One more lies"));
    m_files->setItemText(0, tr("One GLB file"));
    m_files->setItemText(1, tr("A folder: GLB and PNG pictures"));
    m_selection->setText(tr("Selection only"));
    m_buttons->button(QDialogButtonBox::Save)->setText(tr("Save…"));
    m_buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    updateMessage();
}

} // namespace ramure
