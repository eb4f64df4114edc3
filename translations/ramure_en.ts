<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ArmOverlay</name>
    <message numerus="yes">
        <source>%n angle(s) at a limit</source>
        <translation>
            <numerusform>%n angle at a limit</numerusform>
            <numerusform>%n angles at a limit</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>residual %1 after %n step(s)</source>
        <translation>
            <numerusform>residual %1 after %n step</numerusform>
            <numerusform>residual %1 after %n steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DocumentCommand</name>
    <message numerus="yes">
        <source>Roll %n branch(es)</source>
        <translation>
            <numerusform>Roll %n branch</numerusform>
            <numerusform>Roll %n branches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n node(s)</source>
        <translation>
            <numerusform>Delete %n node</numerusform>
            <numerusform>Delete %n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n node(s)</source>
        <translation>
            <numerusform>Duplicate %n node</numerusform>
            <numerusform>Duplicate %n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Shape %n limb(s)</source>
        <translation>
            <numerusform>Shape %n limb</numerusform>
            <numerusform>Shape %n limbs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n edit(s) of the tree</source>
        <translation>
            <numerusform>Delete %n edit of the tree</numerusform>
            <numerusform>Delete %n edits of the tree</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Switch %n edit(s) on</source>
        <translation>
            <numerusform>Switch %n edit on</numerusform>
            <numerusform>Switch %n edits on</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Switch %n edit(s) off</source>
        <translation>
            <numerusform>Switch %n edit off</numerusform>
            <numerusform>Switch %n edits off</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Copy %n edit(s) of the tree</source>
        <translation>
            <numerusform>Copy %n edit of the tree</numerusform>
            <numerusform>Copy %n edits of the tree</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n step(s)</source>
        <translation>
            <numerusform>Duplicate %n step</numerusform>
            <numerusform>Duplicate %n steps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message numerus="yes">
        <source>%Ln defect(s)</source>
        <translation>
            <numerusform>%Ln defect</numerusform>
            <numerusform>%Ln defects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of branches collide</source>
        <translation>
            <numerusform>%Ln pair of branches collides</numerusform>
            <numerusform>%Ln pairs of branches collide</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of triangles run through each other</source>
        <translation>
            <numerusform>%Ln pair of triangles runs through each other</numerusform>
            <numerusform>%Ln pairs of triangles run through each other</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The meshes of %Ln tree(s) are broken: %1.</source>
        <translation>
            <numerusform>The mesh of %Ln tree is broken: %1.</numerusform>
            <numerusform>The meshes of %Ln trees are broken: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The meshes of %Ln tree(s) are closed. %1: that matters for a print alone.</source>
        <translation>
            <numerusform>The mesh of %Ln tree is closed. %1: that matters for a print alone.</numerusform>
            <numerusform>The meshes of %Ln trees are closed. %1: that matters for a print alone.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>NodeWords</name>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n node</numerusform>
            <numerusform>%n nodes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReportTexts</name>
    <message numerus="yes">
        <source>%1 vertices, %2 faces, volume %3, Euler characteristic %4, %Ln piece(s)</source>
        <translation>
            <numerusform>%1 vertices, %2 faces, volume %3, Euler characteristic %4, %Ln piece</numerusform>
            <numerusform>%1 vertices, %2 faces, volume %3, Euler characteristic %4, %Ln pieces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln defect(s)</source>
        <translation>
            <numerusform>%Ln defect</numerusform>
            <numerusform>%Ln defects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of triangles cross at forks.</source>
        <translation>
            <numerusform>%Ln pair of triangles crosses at forks.</numerusform>
            <numerusform>%Ln pairs of triangles cross at forks.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of branches collide (%1 pairs of triangles).</source>
        <translation>
            <numerusform>%Ln pair of branches collides (%1 pairs of triangles).</numerusform>
            <numerusform>%Ln pairs of branches collide (%1 pairs of triangles).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 vertices, %2 faces, Euler characteristic %3, %Ln piece(s)</source>
        <translation>
            <numerusform>%1 vertices, %2 faces, Euler characteristic %3, %Ln piece</numerusform>
            <numerusform>%1 vertices, %2 faces, Euler characteristic %3, %Ln pieces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Closed, but %Ln pair(s) of triangles run through each other</source>
        <translation>
            <numerusform>Closed, but %Ln pair of triangles runs through each other</numerusform>
            <numerusform>Closed, but %Ln pairs of triangles run through each other</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Oriented, but %Ln pair(s) of triangles run through each other</source>
        <translation>
            <numerusform>Oriented, but %Ln pair of triangles runs through each other</numerusform>
            <numerusform>Oriented, but %Ln pairs of triangles run through each other</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of triangles run through each other.</source>
        <translation>
            <numerusform>%Ln pair of triangles runs through each other.</numerusform>
            <numerusform>%Ln pairs of triangles run through each other.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pair(s) of vertices within %1 of each other</source>
        <translation>
            <numerusform>%Ln pair of vertices within %1 of each other</numerusform>
            <numerusform>%Ln pairs of vertices within %1 of each other</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::BakeKeysDialog</name>
    <message numerus="yes">
        <source>At most %n key(s) for each angle. Then the arm follows its keys, no target.</source>
        <translation>
            <numerusform>At most %n key for each angle. Then the arm follows its keys, no target.</numerusform>
            <numerusform>At most %n keys for each angle. Then the arm follows its keys, no target.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) for each angle. Then the arm follows its keys, no target.</source>
        <translation>
            <numerusform>%n key for each angle. Then the arm follows its keys, no target.</numerusform>
            <numerusform>%n keys for each angle. Then the arm follows its keys, no target.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::BranchFactForm</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::BranchInspector</name>
    <message numerus="yes">
        <source>%1 · the active one of %n selected branch(es)</source>
        <translation>
            <numerusform>%1 · the active one of %n selected branch</numerusform>
            <numerusform>%1 · the active one of %n selected branches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::EditActions</name>
    <message numerus="yes">
        <source>De&amp;lete %Ln branch(es)</source>
        <translation>
            <numerusform>De&amp;lete %Ln branch</numerusform>
            <numerusform>De&amp;lete %Ln branches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::EditTool</name>
    <message numerus="yes">
        <source>At %n place(s) around the trunk no limb is like it: nothing happens there.</source>
        <translation>
            <numerusform>At %n place around the trunk no limb is like it: nothing happens there.</numerusform>
            <numerusform>At %n places around the trunk no limb is like it: nothing happens there.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n branch(es), %1 m</source>
        <translation>
            <numerusform>%n branch, %1 m</numerusform>
            <numerusform>%n branches, %1 m</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::ExportDialog</name>
    <message numerus="yes">
        <source>%Ln file(s)</source>
        <translation>
            <numerusform>%Ln file</numerusform>
            <numerusform>%Ln files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln frame(s) in one file</source>
        <translation>
            <numerusform>%Ln frame in one file</numerusform>
            <numerusform>%Ln frames in one file</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln of these files are there already. “Replace” writes over them.</source>
        <translation>
            <numerusform>%Ln of these files is there already. “Replace” writes over it.</numerusform>
            <numerusform>%Ln of these files are there already. “Replace” writes over them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::FileActions</name>
    <message numerus="yes">
        <source>%n picture(s) copied into “%1”.</source>
        <translation>
            <numerusform>%n picture copied into “%1”.</numerusform>
            <numerusform>%n pictures copied into “%1”.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::GenerationsView</name>
    <message numerus="yes">
        <source>%Ln symbol(s)</source>
        <translation>
            <numerusform>%Ln symbol</numerusform>
            <numerusform>%Ln symbols</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branch</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>more than %Ln symbol(s)</source>
        <translation>
            <numerusform>more than %Ln symbol</numerusform>
            <numerusform>more than %Ln symbols</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>… and %Ln more generation(s)</source>
        <translation>
            <numerusform>… and %Ln more generation</numerusform>
            <numerusform>… and %Ln more generations</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::GrammarEditor</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(and %n more)</numerusform>
            <numerusform>(and %n more)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::GroupSection</name>
    <message numerus="yes">
        <source>%n value(s) changed</source>
        <translation>
            <numerusform>%n value changed</numerusform>
            <numerusform>%n values changed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::ImportActions</name>
    <message numerus="yes">
        <source>… and %n more note(s)</source>
        <translation>
            <numerusform>… and %n more note</numerusform>
            <numerusform>… and %n more notes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::IsolationButton</name>
    <message numerus="yes">
        <source>%Ln branch(es) alone</source>
        <translation>
            <numerusform>%Ln branch alone</numerusform>
            <numerusform>%Ln branches alone</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::KeyCommands</name>
    <message numerus="yes">
        <source>%n key(s) copied</source>
        <translation>
            <numerusform>%n key copied</numerusform>
            <numerusform>%n keys copied</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::KeyPanel</name>
    <message numerus="yes">
        <source>%n key(s) selected</source>
        <translation>
            <numerusform>%n key selected</numerusform>
            <numerusform>%n keys selected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::KeyRowList</name>
    <message numerus="yes">
        <source>%n key(s)</source>
        <translation>
            <numerusform>%n key</numerusform>
            <numerusform>%n keys</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::LevelsPanel</name>
    <message numerus="yes">
        <source>Copied %Ln level(s)</source>
        <translation>
            <numerusform>Copied %Ln level</numerusform>
            <numerusform>Copied %Ln levels</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::LimbTool</name>
    <message numerus="yes">
        <source>%n branch(es) follow</source>
        <translation>
            <numerusform>%n branch follows</numerusform>
            <numerusform>%n branches follow</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::MainWindow</name>
    <message numerus="yes">
        <source>Writing %Ln file(s)</source>
        <translation>
            <numerusform>Writing %Ln file</numerusform>
            <numerusform>Writing %Ln files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln file(s) written to %1</source>
        <translation>
            <numerusform>%Ln file written to %1</numerusform>
            <numerusform>%Ln files written to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::PrintPreview</name>
    <message numerus="yes">
        <source>%n closed</source>
        <comment>pieces</comment>
        <translation>
            <numerusform>%n closed</numerusform>
            <numerusform>%n closed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::PropertiesPanel</name>
    <message numerus="yes">
        <source>%n node(s) selected</source>
        <translation>
            <numerusform>%n node selected</numerusform>
            <numerusform>%n nodes selected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::RecipeModel</name>
    <message numerus="yes">
        <source>%n chosen axis(es)</source>
        <translation>
            <numerusform>%n chosen axis</numerusform>
            <numerusform>%n chosen axes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hand edit(s)</source>
        <translation>
            <numerusform>%n hand edit</numerusform>
            <numerusform>%n hand edits</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::RollEditor</name>
    <message numerus="yes">
        <source>For all %n selected branch(es).</source>
        <translation>
            <numerusform>For the selected branch.</numerusform>
            <numerusform>For all %n selected branches.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::SawTool</name>
    <message numerus="yes">
        <source>%n cut(s)</source>
        <translation>
            <numerusform>%n cut</numerusform>
            <numerusform>%n cuts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::SceneModel</name>
    <message numerus="yes">
        <source>%Ln branch(es) in all</source>
        <translation>
            <numerusform>%Ln branch in all</numerusform>
            <numerusform>%Ln branches in all</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branch</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::SceneSearch</name>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n node</numerusform>
            <numerusform>%n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branch</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln limb(s) or twig(s)</source>
        <translation>
            <numerusform>%Ln limb or twig</numerusform>
            <numerusform>%Ln limbs and twigs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::SectionBrowser</name>
    <message numerus="yes">
        <source>%n section(s) copied as CSV</source>
        <translation>
            <numerusform>%n section copied as CSV</numerusform>
            <numerusform>%n sections copied as CSV</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::SeedsDialog</name>
    <message numerus="yes">
        <source>Seed %1, %n year(s)</source>
        <comment>2, 40 years</comment>
        <translation>
            <numerusform>Seed %1, %n year</numerusform>
            <numerusform>Seed %1, %n years</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::SeparateDialog</name>
    <message numerus="yes">
        <source>All %Ln colliding pair(s) moved apart</source>
        <translation>
            <numerusform>The colliding pair was moved apart</numerusform>
            <numerusform>All %Ln colliding pairs moved apart</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln colliding pair(s) moved apart; the rest are listed</source>
        <translation>
            <numerusform>%1 of %Ln colliding pair moved apart; the rest are listed</numerusform>
            <numerusform>%1 of %Ln colliding pairs moved apart; the rest are listed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::StatusPanel</name>
    <message numerus="yes">
        <source>%Ln branch(es)</source>
        <translation>
            <numerusform>%Ln branch</numerusform>
            <numerusform>%Ln branches</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln triangle</numerusform>
            <numerusform>%Ln triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&lt;p&gt;Closed, 2-manifold and outward: every edge has two faces. %Ln pair(s) of triangles run through each other, as twigs do that touch: that matters for a print, which can be made without.&lt;/p&gt;</source>
        <translation>
            <numerusform>&lt;p&gt;Closed, 2-manifold and outward: every edge has two faces. %Ln pair of triangles runs through each other, as twigs do that touch: that matters for a print, which can be made without.&lt;/p&gt;</numerusform>
            <numerusform>&lt;p&gt;Closed, 2-manifold and outward: every edge has two faces. %Ln pairs of triangles run through each other, as twigs do that touch: that matters for a print, which can be made without.&lt;/p&gt;</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::TimelinePanel</name>
    <message numerus="yes">
        <source>%n frame(s) dropped</source>
        <translation>
            <numerusform>%n frame dropped</numerusform>
            <numerusform>%n frames dropped</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::UnplacedButton</name>
    <message numerus="yes">
        <source>%Ln edit(s) without a place</source>
        <translation>
            <numerusform>%Ln edit without a place</numerusform>
            <numerusform>%Ln edits without a place</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ramure::VariationsDialog</name>
    <message numerus="yes">
        <source>%Ln tree(s) written: ramure-cli batch &quot;%1&quot; -o FOLDER grows them.</source>
        <translation>
            <numerusform>%Ln tree written: ramure-cli batch &quot;%1&quot; -o FOLDER grows it.</numerusform>
            <numerusform>%Ln trees written: ramure-cli batch &quot;%1&quot; -o FOLDER grows them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln tree(s), </source>
        <translation>
            <numerusform>%Ln tree, </numerusform>
            <numerusform>%Ln trees, </numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln with a star</source>
        <translation>
            <numerusform>%Ln with a star</numerusform>
            <numerusform>%Ln with a star</numerusform>
        </translation>
    </message>
</context>
</TS>
