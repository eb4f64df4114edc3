#include "widgets/dialogs/export/print_preview.h"

#include "widgets/base/named.h"
#include "widgets/dialogs/export/print_view.h"
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

QString mm(double metres, int digits = 1)
{
    return QLocale().toString(mmPerMetre * metres, 'f', digits);
}

QPixmap swatch(const glm::u8vec3& rgb, bool isRing, qreal ratio)
{
    constexpr int side = 12;
    QPixmap map(QSizeF(side * ratio, side * ratio).toSize());
    map.setDevicePixelRatio(ratio);
    map.fill(Qt::transparent);
    QPainter painter(&map);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour(rgb.r, rgb.g, rgb.b);
    if (isRing) {
        painter.setPen(QPen(colour, 2.0));
        painter.drawEllipse(QRectF(1.5, 1.5, side - 3.0, side - 3.0));
    } else {
        painter.fillRect(QRectF(0.0, 0.0, side, side), colour);
    }
    return map;
}

/// The theme goes by the name.
void setNamed(QLabel* label, const QString& name)
{
    if (label->objectName() == name)
        return;
    label->setObjectName(name);
    label->style()->unpolish(label);
    label->style()->polish(label);
}

} // namespace

PrintPreview::PrintPreview(QWidget* parent)
    : QWidget(parent)
    , m_view(new PrintView(this))
    , m_show(new QPushButton(this))
    , m_whole(new QPushButton(this))
{
    setObjectName(QStringLiteral("printReport"));
    build();
    connect(m_show, &QPushButton::clicked, m_view, &PrintView::showThinnest);
    connect(m_whole, &QPushButton::clicked, m_view, &PrintView::showWhole);
    setTexts();
}

void PrintPreview::build()
{
    auto* rows = new QGridLayout;
    rows->setHorizontalSpacing(10);
    rows->setVerticalSpacing(5);
    rows->setColumnStretch(1, 1);
    for (int row = 0; row < Rows; ++row) {
        m_names[row] = new QLabel(this);
        m_values[row] = new QLabel(this);
        m_values[row]->setTextFormat(Qt::PlainText);
        m_values[row]->setWordWrap(true);
        m_values[row]->setTextInteractionFlags(Qt::TextSelectableByMouse);
        rows->addWidget(m_names[row], row, 0, Qt::AlignTop);
        rows->addWidget(m_values[row], row, 1);
    }
    m_show->setObjectName(QStringLiteral("printShowThinnest"));
    m_whole->setObjectName(QStringLiteral("printShowWhole"));
    auto* places = new QHBoxLayout;
    places->setSpacing(8);
    for (QPushButton* button : {m_show, m_whole}) {
        button->setAutoDefault(false);
        places->addWidget(button);
    }
    places->addStretch(1);
    auto* side = new QVBoxLayout;
    side->setSpacing(8);
    side->addLayout(rows);
    side->addLayout(places);
    side->addWidget(legend("overhang", m_overhangs));
    side->addWidget(legend("thinnest", m_ring));
    side->addStretch(1);
    auto* all = layoutOf<QHBoxLayout>(this, 14);
    all->addWidget(m_view, 1);
    all->addLayout(side, 1);
}

/// A colour of the picture, and what it stands for.
QWidget* PrintPreview::legend(const char* name, QLabel*& text)
{
    const bool isRing = qstrcmp(name, "thinnest") == 0;
    auto* holder = new QWidget(this);
    auto* row = layoutOf<QHBoxLayout>(holder, 8);
    auto* colour = new QLabel(holder);
    colour->setPixmap(swatch(isRing ? thinnestColour : overhangColour, isRing, devicePixelRatioF()));
    text = new QLabel(holder);
    text->setWordWrap(true);
    row->addWidget(colour);
    row->addWidget(text, 1);
    return holder;
}

void PrintPreview::setPrint(std::shared_ptr<const PrintedTree> print, const PrintOptions& asked)
{
    m_print = std::move(print);
    m_asked = asked;
    m_view->setPrint(m_print);
    fill();
}

QString PrintPreview::text() const
{
    QStringList lines;
    for (int row = 0; row < Rows; ++row)
        if (!m_values[row]->text().isEmpty())
            lines += m_names[row]->text() + QStringLiteral(": ") + m_values[row]->text();
    return lines.join(u'\n');
}

void PrintPreview::setRow(Row row, const QString& value, bool isProblem)
{
    m_values[row]->setText(value);
    setNamed(m_values[row], isProblem ? QStringLiteral("problem") : QString());
    m_names[row]->setVisible(!value.isEmpty());
    m_values[row]->setVisible(!value.isEmpty());
}

void PrintPreview::fill()
{
    if (!m_print)
        return;
    const PrintReport& r = m_print->report;
    const QLocale locale;
    const glm::dvec3 size = r.size(), at = r.thinnestAt;
    setRow(Size, tr("%1 × %2 × %3 mm").arg(mm(size.x), mm(size.z), mm(size.y)));
    setRow(Scale, QStringLiteral("1 : ") + locale.toString(1.0 / m_print->scale, 'f', 1));
    setRow(Volume, tr("%1 cm³").arg(locale.toString(1e6 * r.volume, 'f', 1)));
    constexpr double near = 0.99;
    setRow(Thinnest, tr("%1 mm of %2").arg(mm(r.thinnest, 2), mm(m_asked.smallestDiameter(), 2)),
           r.thinnest < near * m_asked.smallestDiameter());
    m_values[Thinnest]->setToolTip(tr("At (%1, %2, %3) mm").arg(mm(at.x), mm(-at.z), mm(at.y)));
    setRow(Overhang, tr("%1 cm²").arg(locale.toString(1e4 * r.overhang, 'f', 1)));
    if (!std::isfinite(r.balance))
        setRow(Balance, tr("no: not on the ground"), true);
    else if (r.standsUp())
        setRow(Balance, tr("yes, by %1 mm").arg(mm(r.balance)));
    else
        setRow(Balance, tr("no, by %1 mm").arg(mm(-r.balance)), true);
    setRow(Pieces, tr("%n closed", "pieces", static_cast<int>(r.pieces)), r.pieces != 1 || !r.isClosed);
    setRow(Triangles, locale.toString(r.triangles));
    setRow(
        Branches,
        tr("%1 thickened, %2 cut").arg(locale.toString(m_print->thickened), locale.toString(m_print->cut)));
    const bool hasLeaves = m_asked.leaves != PrintLeaves::Off;
    setRow(Leaves, hasLeaves
                       ? tr("%1 shells, %2 left out")
                             .arg(locale.toString(m_print->leaves), locale.toString(m_print->leavesLeftOut))
                       : QString());
}

void PrintPreview::setTexts()
{
    const QString names[Rows] = {tr("Size"),      tr("Scale"),  tr("Volume"), tr("Thinnest place"),
                                 tr("Overhangs"), tr("Stands"), tr("Pieces"), tr("Triangles"),
                                 tr("Branches"),  tr("Leaves")};
    for (int row = 0; row < Rows; ++row)
        m_names[row]->setText(names[row]);
    m_names[Overhang]->setToolTip(tr("Area that overhangs by more than 45°, in cm²: it needs supports"));
    m_names[Balance]->setToolTip(
        tr("Whether its centre of mass is over the foot, and how far from the foot’s border, in mm"));
    m_show->setText(tr("Thinnest place"));
    m_show->setToolTip(tr("The picture flies there"));
    m_whole->setText(tr("Whole print"));
    m_whole->setToolTip(tr("All of it comes into the picture"));
    m_overhangs->setText(tr("Overhangs steeper than 45°"));
    m_ring->setText(tr("Thinnest place"));
    fill();
}

} // namespace ramure
