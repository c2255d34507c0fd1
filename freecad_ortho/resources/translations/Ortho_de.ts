<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>App::Property</name>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>All combinations, any of which can be drawn</source>
   <translation>Alle Kombinationen, von denen jede gezeichnet werden kann</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Anchor: four anchor bolts hold a base plate</source>
   <translation>Anker: vier Anker halten eine Fußplatte</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>As ForcesAlong, of all combinations, one by one</source>
   <translation>Wie ForcesAlong, aller Kombinationen, eine nach der anderen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At hubs: the panels' corners are cut off beside hubs, or the panels lifted over them</source>
   <translation>An Naben: neben Naben sind die Ecken der Platten abgeschnitten, oder die Platten über sie gehoben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the larger one</source>
   <translation>In ihrem Scheitel hat die Fläche diesen Krümmungsradius, den größeren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the smaller one</source>
   <translation>In ihrem Scheitel hat die Fläche diesen Krümmungsradius, den kleineren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At the border the net overhangs the surface, to be trimmed, or bends to follow it</source>
   <translation>Am Rand ragt das Netz über die Fläche hinaus, um beschnitten zu werden, oder biegt sich ihm entlang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Axial force of each member where it is used most, kN; tension positive</source>
   <translation>Normalkraft jedes Stabs, wo er am stärksten ausgenutzt ist, kN; Zug positiv</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Balance is found in the deformed, imperfect shape</source>
   <translation>Das Gleichgewicht wird in der verformten, unvollkommenen Form gefunden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Beams or lamellas whose section and material count; empty: those given here</source>
   <translation>Träger oder Lamellen, deren Querschnitt und Material zählen; leer: die hier angegebenen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Beams pass that twist by this at most; 0: any</source>
   <translation>Träger bestehen, die sich höchstens so verwinden; 0: beliebig</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Beams that the parts lie on or join; empty: the net</source>
   <translation>Träger, auf denen die Teile liegen oder die sie verbinden; leer: das Netz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bend radius: folds have this radius inside, by default that of the thickness; 0 is automatic</source>
   <translation>Biegeradius: Kantungen haben innen diesen Radius, sonst den der Dicke; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bending: the panels are flat, or bent cold into faces that are not planar</source>
   <translation>Biegung: die Platten sind eben oder kalt in nicht ebene Flächen gebogen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bite: joints of structural silicone are this wide</source>
   <translation>Fugenbreite: so breit sind Fugen aus tragendem Silikon</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Blue at and below this value (mm, 1/m, 1/m2, degrees) if not automatic</source>
   <translation>Blau bei und unter diesem Wert (mm, 1/m, 1/m2, Grad), wenn nicht automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolt: beams are bolted with bolts of this size</source>
   <translation>Schraube: die Träger werden mit Schrauben dieser Größe angeschlossen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolts: a joint has so many bolts above each other</source>
   <translation>Schrauben: so viele Schrauben hat ein Anschluss übereinander</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cables have this force density; 0 is the same</source>
   <translation>Randseile haben diese Kraftdichte; 0 heißt dieselbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cut: the strips end square before the border, or along it</source>
   <translation>Randschnitt: die Streifen enden rechtwinklig vor dem Rand oder an ihm entlang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bore: the hubs have a hole of this diameter along their axis</source>
   <translation>Bohrung: die Naben haben ein Loch dieses Durchmessers längs ihrer Achse</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Buckling shape that is drawn; 1 is the first</source>
   <translation>Gezeichnete Knickform; 1 ist die erste</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC nets: the vertex spheres have this radius; 0 is free</source>
   <translation>CMC-Netze: Die Eckenkugeln haben diesen Radius; 0 heißt frei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: each direction has a length of its own</source>
   <translation>Tschebyschow-Netze: jede Richtung hat eine eigene Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: the edges are this long; 0 is free</source>
   <translation>Tschebyschow-Netze: Die Kanten sind so lang; 0 heißt frei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clear distance: parts keep so far from each other and from the rim</source>
   <translation>Abstand: so weit bleiben Teile voneinander und vom Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clearance: slots and hubs leave this much air; 0 is 1 mm, slots by material</source>
   <translation>Spiel: Schlitze und Naben lassen so viel Luft; 0 heißt 1 mm, Schlitze je Material</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cleats: angles with bolts join strips where these end</source>
   <translation>Winkel: Winkel mit Schrauben verbinden Streifen an ihren Enden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Colour of the edges</source>
   <translation>Farbe der Kanten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Colour of the faces where no colour map is shown</source>
   <translation>Farbe der Maschen, wo keine Farbkarte gezeigt wird</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Combination whose forces and displacements are drawn, first order</source>
   <translation>Kombination, deren Kräfte und Verschiebungen gezeichnet werden, erste Ordnung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Combination whose forces are drawn as diagrams</source>
   <translation>Kombination, deren Schnittgrößen als Verläufe gezeichnet werden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Counts, accuracy and masses, as JSON</source>
   <translation>Anzahlen, Genauigkeit und Massen, als JSON</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Cut parts along the border of the surface, where the net has one</source>
   <translation>Teile entlang des Randes der Fläche schneiden, wo das Netz einen hat</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cutter: slots have round corners for a milling cutter of this diameter; 0 is sharp corners</source>
   <translation>Fräser: Schlitze haben runde Ecken für einen Fräser dieses Durchmessers; 0 heißt scharfe Ecken</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Density in kg/m3; 0: that of the material</source>
   <translation>Dichte in kg/m3; 0: die des Materials</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Diagonals: a third layer lies along these diagonals, which brace the net</source>
   <translation>Diagonalen: eine dritte Lage liegt auf diesen Diagonalen, die das Netz aussteifen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Displacements are drawn so many times as large; 0: as it fits</source>
   <translation>Verschiebungen werden so vielfach gezeichnet; 0: wie es passt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Distortion: a patch is built up to this distortion of an edge</source>
   <translation>Verzerrung: ein Flächenstück wird bis zu dieser Verzerrung einer Kante gebaut</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Each vertex carries this load, a force along x, y and z</source>
   <translation>Jede Ecke trägt diese Last, eine Kraft längs x, y und z</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Edge beam that the parts end at or lie on</source>
   <translation>Randträger, an dem die Teile enden oder auf dem sie liegen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge cover: panels reach this far under pressure plates, by default 15 mm or as glass needs; 0 is automatic</source>
   <translation>Einstand: so weit reichen Platten unter die Pressleisten, standardmäßig 15 mm oder wie Glas es braucht; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge height: the edge beam is this high, by default as high as the beams; 0 is automatic</source>
   <translation>Randhöhe: so hoch ist der Randträger, sonst so hoch wie die Träger; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge section: the edge beam has this cross section, or one of the catalogue such as HEB160</source>
   <translation>Randprofil: der Randträger hat diesen Querschnitt oder einen des Katalogs wie HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge wall: the walls of a tube along the edge are this thick</source>
   <translation>Rohrwand: so dick sind die Wände eines Rohrs am Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge width: the edge beam is this wide, by default as thick as the plates or 60 mm; 0 is automatic</source>
   <translation>Randbreite: so breit ist der Randträger, sonst so dick wie die Bleche oder 60 mm; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Edges and faces that vertices glide on, exactly</source>
   <translation>Kanten und Flächen, auf denen Ecken exakt gleiten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long</source>
   <translation>Kanten sind etwa so lang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long, whatever the sampling</source>
   <translation>Kanten sind etwa so lang, gleich welche Abtastung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of nodes may be turned this far from the shape of their kind</source>
   <translation>Kanten von Knoten dürfen so weit von der Form ihrer Art verdreht sein</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of the other family of lines are so many times as long</source>
   <translation>Kanten der anderen Linienschar sind so viele Male so lang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Edges, wires and sketches that lines of the net run along</source>
   <translation>Kanten, Kantenzüge und Skizzen, an denen Linien des Netzes entlanglaufen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends of members are rigid, hinged, or have springs of this stiffness in kNm/rad</source>
   <translation>Stabenden sind starr, gelenkig oder haben Federn dieser Steifigkeit in kNm/rad (rigid, hinged oder die Zahl)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends: the beams meet like this at a node</source>
   <translation>Enden: so treffen sich die Träger an einem Knoten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every so many lines of u and v stay</source>
   <translation>Jede so vielte Linie von u und v bleibt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces at inner irregular vertices are left out, or asked for right angles too, which no smooth surface has there</source>
   <translation>Flächen an inneren irregulären Ecken bleiben aus, oder auch von ihnen werden rechte Winkel verlangt, die dort keine glatte Fläche hat</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces keep their shape the more of it there is, such as 10; none is usual; -1 is automatic</source>
   <translation>Je mehr davon, desto mehr behalten Flächen ihre Form, etwa 10; üblich ist keines; -1 ist automatisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Faces that the net is sampled from and stays linked to</source>
   <translation>Flächen, aus denen das Netz abgetastet ist und mit denen es verknüpft bleibt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Faces that the net stays near as far as it can</source>
   <translation>Flächen, denen das Netz so nahe bleibt, wie es kann</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Few kinds are wanted of these parts, once the net is reached</source>
   <translation>Von diesen Teilen sind wenige Arten gewünscht, sobald das Netz erreicht ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>File that the net came from</source>
   <translation>Datei, aus der das Netz kam</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flange thickness: the flanges are this thick, by default as thick as the plates; 0 is automatic</source>
   <translation>Flanschdicke: die Flansche sind so dick, ohne Angabe so dick wie die Bleche; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>Flat patterns that the picture shows</source>
   <translation>Abwicklungen, die das Bild zeigt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Fold: edges of metal panels are folded down by this</source>
   <translation>Kantung: Ränder von Blechplatten werden um dieses Maß abgekantet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>Follow each change at once, if that does not take long; else only when asked to</source>
   <translation>Jeder Änderung sofort folgen, wenn das nicht lange dauert; sonst nur auf Verlangen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot at: these vertices stand on feet: corners, boundary, or their numbers as 0,12,40</source>
   <translation>Füße an: diese Ecken stehen auf Füßen: corners, boundary oder ihre Nummern wie 0,12,40</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot height: the base plates lie this far below the vertices</source>
   <translation>Fußhöhe: so weit liegen die Fußplatten unter den Ecken</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot plate: base plates and caps are this thick</source>
   <translation>Fußplatte: so dick sind Fuß- und Kopfplatten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>For buckling and second order each member has so many pieces</source>
   <translation>Für Knicken und zweite Ordnung hat jeder Stab so viele Stücke</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>Force on each node of the mesh, N</source>
   <translation>Kraft auf jeden Knoten des Netzes, N</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Force that is drawn across the members, red where positive</source>
   <translation>Schnittgröße, die quer zu den Stäben gezeichnet wird, rot wo positiv</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame width: pressure plates and caps are this wide, by default 50 mm or as wide as glass needs; 0 is automatic</source>
   <translation>Rahmenbreite: so breit sind Press- und Deckleisten, standardmäßig 50 mm oder wie Glas es braucht; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame: pressure plates and caps hold the panels, or structural silicone on adapters</source>
   <translation>Rahmen: Press- und Deckleisten halten die Platten, oder tragendes Silikon auf Adaptern</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gap: the joint between two panels is this wide</source>
   <translation>Fuge: die Fuge zwischen zwei Platten ist so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gap: the joint between two patches is this wide</source>
   <translation>Fuge: die Fuge zwischen zwei Flächenstücken ist so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gasket: gaskets below and above framed panels are this thick</source>
   <translation>Dichtung: so dick sind die Dichtungen unter und über gerahmten Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Gliding without an object: boundary, or such as z=0</source>
   <translation>Gleiten ohne Objekt: boundary, oder etwa z=0</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Grain: parts may turn on the sheet as its grain says</source>
   <translation>Faserrichtung: Teile drehen sich auf der Tafel, wie ihre Faserrichtung es erlaubt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Height of a sheet</source>
   <translation>Höhe einer Tafel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Height: the beams are this high</source>
   <translation>Höhe: die Träger sind so hoch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hole: the bolt holes have this diameter</source>
   <translation>Loch: die Schraubenlöcher haben diesen Durchmesser</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>How many of these points each of the curves has</source>
   <translation>Wie viele dieser Punkte jede der Kurven hat</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>How many vertices each face has, where some have more or fewer than four</source>
   <translation>Wie viele Punkte jede Fläche hat, wo einige mehr oder weniger als vier haben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub diameter: the hubs measure this across their faces; 0 is 100 mm, of bolted ones what each needs</source>
   <translation>Nabendurchmesser: so viel messen die Naben über ihre Flächen; 0 heißt 100 mm, geschraubte so groß wie nötig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub wall: bolted hubs have walls of this thickness; 0 is as thick as the bolts</source>
   <translation>Nabenwand: geschraubte Naben haben Wände dieser Dicke; 0 heißt so dick wie die Schrauben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Isometric nets: faces keep the shape that this net has; empty: as it starts</source>
   <translation>Isometrische Netze: Flächen behalten die Form, die dieses Netz hat; leer: wie es beginnt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>It is asked of the diagonals of the faces, not of the edges</source>
   <translation>Verlangt wird es von den Diagonalen der Flächen, nicht von den Kanten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>K factor: folds keep the length of the fibre at this part of the thickness, 0: by DIN 6935</source>
   <translation>k-Faktor: Kantungen behalten die Länge der Faser bei diesem Teil der Dicke; 0: nach DIN 6935</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Keep the last line where the step misses it</source>
   <translation>Die letzte Linie behalten, wo der Schritt sie verfehlt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kerf: outlines grow by half this width of a cut</source>
   <translation>Schnittfuge: Umrisse wachsen um die halbe Breite der Schnittfuge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Largest displacement that passes</source>
   <translation>Größte zulässige Verschiebung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Largest share of the strain energy that is not of axial forces, %</source>
   <translation>Größter Anteil der Formänderungsarbeit, der nicht von Normalkräften kommt, %</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Layers: one layer has slots where strips cross, two have bolt holes</source>
   <translation>Lagen: eine Lage hat Schlitze, wo Streifen sich kreuzen, zwei haben Schraubenlöcher</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Least factor on the loads; 0 where nothing buckles</source>
   <translation>Kleinster Faktor auf die Lasten; 0, wo nichts knickt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least length: beams that are shorter than this at the border are left out</source>
   <translation>Mindestlänge: Träger, die am Rand kürzer sind, werden weggelassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least width: pieces of panels at the border that are narrower than this are slivers</source>
   <translation>Mindestbreite: Stücke von Platten am Rand, die schmaler sind, sind Splitter</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>Length on the page of a length of one</source>
   <translation>Länge auf dem Blatt für eine Länge von eins</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Lengths, curvatures, angles: range from the values</source>
   <translation>Längen, Krümmungen, Winkel: Bereich aus den Werten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Less than 1 moves the centre farther away</source>
   <translation>Weniger als 1 rückt das Zentrum weiter weg</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Lines as 'strength: 1.35 self-weight + 1.5 snow'; empty: those of EN 1990</source>
   <translation>Zeilen wie 'strength: 1.35 self-weight + 1.5 snow'; leer: die der EN 1990</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines stand at even distances, or at equal steps of the parameters</source>
   <translation>Linien stehen in gleichen Abständen oder gleichen Schritten der Parameter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u and v lie in two layers, u above, the middles of their sections this far apart</source>
   <translation>Linien u und v liegen in zwei Lagen, u oben, die Mitten ihrer Querschnitte so weit auseinander</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u, lines v and diagonals of a web are these: a asymptotic, g geodesic</source>
   <translation>Linien u, Linien v und Diagonalen eines Gewebes sind dies: a asymptotisch, g geodätisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>Load case of the structural check</source>
   <translation>Lastfall der statischen Prüfung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Louvre axis: the louvres turn about lines of this family</source>
   <translation>Lamellenachse: die Sonnenlamellen drehen um Linien dieser Schar</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Make the net anew when its source changes; off once its vertices were moved</source>
   <translation>Das Netz neu machen, wenn seine Quelle sich ändert; aus, sobald seine Ecken bewegt wurden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Mark inner vertices with more or fewer than four edges</source>
   <translation>Innere Ecken mit mehr oder weniger als vier Kanten markieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Mark the supported vertices, those of the boundary</source>
   <translation>Die gelagerten Ecken markieren, die des Randes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Mass of all members, kg</source>
   <translation>Masse aller Stäbe, kg</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Material of all parts</source>
   <translation>Material aller Teile</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Members buckle in so many times their length</source>
   <translation>Stäbe knicken auf so viele Male ihre Länge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Mirror planes through the origin: letters of x, y, z</source>
   <translation>Spiegelebenen durch den Ursprung: Buchstaben aus x, y, z</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it bends lines more evenly on the way; none is usual; -1 is automatic</source>
   <translation>Mehr davon biegt Linien unterwegs gleichmäßiger; üblich ist keines; -1 ist automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it draws lines straighter on the way; 0.01 is usual; -1 is automatic</source>
   <translation>Mehr davon zieht Linien unterwegs gerader; üblich ist 0,01; -1 ist automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps direction and length of edges; 0.02 is usual; -1 is automatic</source>
   <translation>Mehr davon erhält Richtung und Länge der Kanten; üblich ist 0,02; -1 ist automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps pairs of faces orthogonal; 0.001 is usual; -1 is automatic</source>
   <translation>Mehr davon hält Paare von Flächen rechtwinklig; üblich ist 0,001; -1 ist automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps vertices nearer to where they are; 0.003 is usual; -1 is automatic</source>
   <translation>Mehr davon hält Ecken näher an ihrem Ort; üblich ist 0,003; -1 ist automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it moves neighbours more alike; 0.1 is usual; -1 is automatic</source>
   <translation>Mehr davon bewegt Nachbarn ähnlicher; üblich ist 0,1; -1 ist automatisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Movements of nodes, then middles of members; modes one after the other</source>
   <translation>Bewegungen der Knoten, dann der Stabmitten; Eigenformen nacheinander</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>N, Vy, Vz, T, My, Mz at start, middle and end of the members, kN, kNm</source>
   <translation>N, Vy, Vz, T, My, Mz am Anfang, in der Mitte und am Ende der Stäbe, kN, kNm</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Names of the parts that do not fit on a sheet</source>
   <translation>Namen der Teile, die auf keine Tafel passen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Names of the parts, in the order of the shape</source>
   <translation>Namen der Teile, in der Reihenfolge der Form</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Names of the parts, in the order of the solids</source>
   <translation>Namen der Teile, in der Reihenfolge der Körper</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Net that the structure is built on</source>
   <translation>Netz, auf dem das Tragwerk steht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Net whose edges are the members</source>
   <translation>Netz, dessen Kanten die Stäbe sind</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Nets that this one is made of</source>
   <translation>Netze, aus denen dieses gemacht ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>New vertices lie in the middle, or all are smoothed</source>
   <translation>Neue Ecken liegen in der Mitte, oder alle werden geglättet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>No boundary beams: no beams are made along the boundary</source>
   <translation>Keine Randträger: längs des Randes entstehen keine Träger</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Node: the beams are joined by hubs or sockets</source>
   <translation>Knoten: die Träger sind durch Naben oder Hülsen verbunden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Nodes of the frame</source>
   <translation>Knoten des Stabwerks</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Nodes of the members, two each</source>
   <translation>Knoten der Stäbe, je zwei</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Nodes whose hubs the panels stay clear of</source>
   <translation>Knoten, von deren Naben die Platten Abstand halten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Number of sheets</source>
   <translation>Anzahl der Tafeln</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Number of the most used member: that of its edge</source>
   <translation>Nummer des am stärksten ausgenutzten Stabs: die seiner Kante</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>Number of the sheet that is shown; 0: all there is</source>
   <translation>Nummer der gezeigten Tafel; 0: alles, was da ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Numbers of further vertices that do not move</source>
   <translation>Nummern weiterer Ecken, die sich nicht bewegen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Numbers of these parameter lines; empty: all</source>
   <translation>Nummern dieser Parameterlinien; leer: alle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Numbers of vertices that are drawn to a place</source>
   <translation>Nummern von Ecken, die an einen Ort gezogen werden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of a node in service</source>
   <translation>Eines Knotens im Gebrauch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the modes under the loads that buckle it first</source>
   <translation>Der Eigenformen unter den Lasten, die es zuerst knicken</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the most used member, %; 100 is all that it has</source>
   <translation>Des am stärksten ausgenutzten Stabs, %; 100 ist alles, was er hat</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the nodes in all combinations, one by one</source>
   <translation>Der Knoten in allen Kombinationen, eine nach der anderen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the nodes, in the service case that moves one most</source>
   <translation>Der Knoten, im Gebrauchsfall, der einen am weitesten bewegt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Offset: the parts lie above the net, about it or below it</source>
   <translation>Lage: die Teile liegen über dem Netz, mittig darin oder darunter</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/structure_view.py" />
   <source>One colour for all parts, or green and red by their verdicts</source>
   <translation>Eine Farbe für alle Teile, oder Grün und Rot nach ihrem Befund</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>One turn rises by this</source>
   <translation>Eine Umdrehung steigt um dies</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Optimise again at once, as before, when the source of a net that was moved changes</source>
   <translation>Gleich noch einmal optimieren, wie zuvor, wenn sich die Quelle eines bewegten Netzes ändert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Other than four lines meet here: auto for the fewest that the surface needs, none, or a file of rows x y z and 3, 5 or 6 lines</source>
   <translation>Hier treffen sich andere als vier Linien: auto für die wenigsten, die die Fläche braucht, none für keine, oder eine Datei mit Zeilen x y z und 3, 5 oder 6 Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Overhang: the strips go this far beyond their last vertex, by default half their width; 0 is automatic</source>
   <translation>Überstand: so weit gehen die Streifen über ihre letzte Ecke hinaus, ohne Angabe um ihre halbe Breite; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel edge: the sides of the panels are square, or bevelled along the beams</source>
   <translation>Plattenkante: die Seiten der Platten sind rechtwinklig, oder längs der Träger abgeschrägt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel thickness: the panels are this thick, by default as thick as the plates; 0 is automatic</source>
   <translation>Plattendicke: die Platten sind so dick, ohne Angabe so dick wie die Bleche; 0 heißt automatisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels and lengths of edges may be this far from the shape of their kind; 0 is 1/1000 of an edge</source>
   <translation>Paneele und Kantenlängen dürfen so weit von der Form ihrer Art abweichen; 0 heißt 1/1000 der Kante</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels weigh this much by their surface, kN/m2</source>
   <translation>Paneele wiegen so viel, bezogen auf ihre Fläche, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels with what holds them have this shear stiffness G t, kN/mm; with 0 they are load only</source>
   <translation>Paneele mit dem, was sie hält, haben diese Schubsteifigkeit G t, kN/mm; mit 0 sind sie nur Last</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Parameter lines that are built on: u, v or both</source>
   <translation>Parameterlinien, auf denen gebaut wird: u, v oder beide</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Part of the sheets that is left over, 0 to 1</source>
   <translation>Teil der Tafeln, der übrig bleibt, 0 bis 1</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts pass that are off a plane or developable by this at most; 0: any</source>
   <translation>Teile bestehen, die höchstens so weit von einer Ebene oder abwickelbaren Fläche abweichen; 0: beliebig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts pass that lean from the surface normal by this at most; 0: any</source>
   <translation>Teile bestehen, die höchstens so weit von der Flächennormalen neigen; 0: beliebig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pattern: the axes unroll to lines of this kind</source>
   <translation>Zuschnitt: die Achsen wickeln zu Linien dieser Art ab</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Piece length: rows are cut along lines of the net into pieces of at most this length; 0 is whole rows</source>
   <translation>Stücklänge: Reihen werden an Linien des Netzes in Stücke von höchstens dieser Länge geschnitten; 0 heißt ganze Reihen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Places that the handles are drawn to, in mm</source>
   <translation>Orte, an die die Griffe gezogen werden, in mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Planar nets: the diagonals of a face are this far apart at most; 0 is exactly flat</source>
   <translation>Ebene Netze: Die Diagonalen einer Fläche sind höchstens so weit auseinander; 0 heißt genau eben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Points of closed curves along which parts are trimmed, in mm</source>
   <translation>Punkte geschlossener Kurven, an denen Teile beschnitten werden, in mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Position: the strips stand on the surface, lie in it, or tilt as the net wants it</source>
   <translation>Lage: die Streifen stehen auf der Fläche, liegen in ihr oder neigen sich, wie das Netz es will</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Positions of the vertices, in mm</source>
   <translation>Lage der Ecken, in mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post diameter: the posts are round tubes of this diameter</source>
   <translation>Pfostenrohr: die Pfosten sind Rundrohre dieses Durchmessers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post wall: the walls of the posts are this thick</source>
   <translation>Pfostenwand: so dick sind die Wände der Pfosten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Quads that the border cuts are set onto it, or left out</source>
   <translation>Vierecke, die der Rand schneidet, werden auf ihn gesetzt oder weggelassen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Quantity that colours the net, explained by the scale in the view</source>
   <translation>Größe, die das Netz färbt, erklärt durch die Skala in der Ansicht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Red at and above this value (mm, 1/m, 1/m2, degrees) if not automatic</source>
   <translation>Rot bei und über diesem Wert (mm, 1/m, 1/m2, Grad), wenn nicht automatisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Report of the last optimisation, as JSON</source>
   <translation>Bericht der letzten Optimierung, als JSON</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Residuals up to this count as zero</source>
   <translation>Residuen bis hierher zählen als null</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Residuals: blue at and below 10 to this power</source>
   <translation>Residuen: blau bei und unter 10 hoch diesem</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Residuals: red at and above 10 to this power</source>
   <translation>Residuen: rot bei und über 10 hoch diesem</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rounded: solids have the rounded corners and roots of a section of the catalogue</source>
   <translation>Gerundet: Körper haben die runden Ecken und Ausrundungen eines Querschnitts des Katalogs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Saw: a saw cut behind a piece is this wide</source>
   <translation>Sägeschnitt: ein Sägeschnitt hinter einem Stück ist so breit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Section and material checked</source>
   <translation>Geprüfter Querschnitt und Werkstoff</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section width: hollow sections and flanges are this wide</source>
   <translation>Breite des Querschnitts: Hohlprofile und Flansche sind so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section: the beams have this cross section, or one of the catalogue such as HEB160</source>
   <translation>Querschnitt: die Träger haben diesen Querschnitt oder einen des Katalogs wie HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sections stand as those of beams do, or as lamellas of plate:THICKNESSxWIDTH: standing, lying or tilted as the net wants it</source>
   <translation>Querschnitte stehen wie die von Trägern oder als Lamellen plate:DICKExBREITE: stehend, liegend oder geneigt, wie das Netz es verlangt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Shape that is drawn: the frame, or how it moves</source>
   <translation>Gezeichnete Form: das Stabwerk oder wie es sich bewegt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet: parts are nested on sheets of this size</source>
   <translation>Tafel: Teile werden auf Tafeln dieser Größe geschachtelt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show an arrow on the side that is up</source>
   <translation>Einen Pfeil auf der Seite zeigen, die oben ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show both diagonals of each face</source>
   <translation>Beide Diagonalen jeder Masche zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show reflection lines instead of colours</source>
   <translation>Reflexionslinien statt Farben zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show spheres through some of the vertex stars</source>
   <translation>Kugeln durch einige der Eckensterne zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the colour scale in the 3D view</source>
   <translation>Die Farbskala in der 3D-Ansicht zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the forces in the edges under equal loads, red for tension</source>
   <translation>Die Kräfte in den Kanten unter gleichen Lasten zeigen, rot für Zug</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the lines between the midpoints of opposite edges</source>
   <translation>Die Linien zwischen den Mittelpunkten gegenüberliegender Kanten zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the load of each free vertex</source>
   <translation>Die Last jeder freien Ecke zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/flat_patterns_view.py" />
   <source>Show the names of the parts</source>
   <translation>Die Namen der Teile zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the normals of the faces on a sphere beside the net</source>
   <translation>Die Normalen der Maschen auf einer Kugel neben dem Netz zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the parameter lines u and v in two colours</source>
   <translation>Die Parameterlinien u und v in zwei Farben zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the rulings of strips along the parameter lines</source>
   <translation>Die Erzeugenden von Streifen längs der Parameterlinien zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Show the scale of the colours</source>
   <translation>Die Farbskala zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the torsion-free axes at the vertices</source>
   <translation>Die torsionsfreien Achsen an den Ecken zeigen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slivers: slivers at the border become part of their neighbours where they can, or are left out</source>
   <translation>Splitter: Splitter am Rand werden, wo es geht, Teil ihrer Nachbarn oder weggelassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slots leave this part of the height of lamellas that cross in one layer; with 1 there are none</source>
   <translation>Schlitze lassen diesen Teil der Höhe von Lamellen, die sich in einer Lage kreuzen; mit 1 gibt es keine</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Smooth: the solids are smooth instead of faceted</source>
   <translation>Glatt: die Körper sind glatt statt facettiert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow also lies on one half, as a case of its own: the half towards this direction</source>
   <translation>Schnee liegt als eigener Fall auch auf einer Hälfte: der in dieser Richtung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow weighs this much by the plan, kN/m2</source>
   <translation>Schnee wiegt so viel, bezogen auf den Grundriss, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>So many mm are drawn for a kN or kNm of the diagram; 0: as it fits</source>
   <translation>So viele mm werden für ein kN oder kNm gezeichnet; 0: wie es passt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many modes of buckling are found</source>
   <translation>So viele Knickformen werden gesucht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rings of faces are cut off at the border</source>
   <translation>So viele Ringe von Flächen werden am Rand abgeschnitten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rows are cut off at the starts and ends of u and v</source>
   <translation>So viele Reihen werden an Anfang und Ende von u und v abgeschnitten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many times four faces are made of one</source>
   <translation>So oft werden aus einer Fläche vier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many vertices stand along u and along v</source>
   <translation>So viele Ecken stehen längs u und längs v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Socket depth: the plates stand this deep in the sockets</source>
   <translation>Hülsentiefe: die Bleche stehen so tief in den Hülsen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Splice every: spliced beams have a splice after so many nodes, 0 for none</source>
   <translation>Stoß alle: gestoßene Träger haben nach so vielen Knoten einen Stoß, 0 für keinen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>Stands for all that the shape was built from</source>
   <translation>Steht für alles, woraus die Form gebaut wurde</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Stands for the net as its source made it last</source>
   <translation>Steht für das Netz, wie seine Quelle es zuletzt gemacht hat</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stock: strips are cut from this length; longer ones are spliced; 0 is as long as it takes</source>
   <translation>Lagerlänge: Streifen werden aus dieser Länge geschnitten; längere werden gestoßen; 0 heißt so lang wie nötig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a millimetre of edge has this weight</source>
   <translation>Spannungsnetze: Ein Millimeter Kante hat dieses Gewicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a square millimetre carries this load, downwards</source>
   <translation>Spannungsnetze: Ein Quadratmillimeter trägt diese Last, nach unten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: edges may carry these forces</source>
   <translation>Spannungsnetze: Kanten dürfen diese Kräfte tragen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: every vertex carries this load, downwards</source>
   <translation>Spannungsnetze: Jede Ecke trägt diese Last, nach unten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: the shell whose stresses the lines follow stands on this</source>
   <translation>Spannungsnetze: Die Schale, deren Spannungen die Linien folgen, steht hierauf</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: this carries the loads: boundary, which slides along its own curve but for its corners; corners or vertices such as 0,5,12, which stay; empty: as the net needs</source>
   <translation>Spannungsnetze: Dies trägt die Lasten: boundary für den Rand, der bis auf seine Ecken längs seiner eigenen Kurve gleitet; corners oder Ecken wie 0,5,12, die bleiben; leer: wie das Netz es braucht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strip: the strips are made of plane faces or twisted</source>
   <translation>Streifen: die Streifen sind aus ebenen Flächen oder verwunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along u have this angle to the surface: 90 stands, 180 lies; 0 is free</source>
   <translation>Streifen längs u haben diesen Winkel zur Fläche: 90 steht, 180 liegt; 0 heißt frei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along v have this angle to the surface: 90 stands, 180 lies; 0 is free</source>
   <translation>Streifen längs v haben diesen Winkel zur Fläche: 90 steht, 180 liegt; 0 heißt frei</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Structure whose weight is a load by the surface, such as panels</source>
   <translation>Tragwerk, dessen Gewicht eine Flächenlast ist, etwa Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Structures whose parts are shown</source>
   <translation>Tragwerke, deren Teile gezeigt werden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along x rises by this, or hangs where it is negative</source>
   <translation>Der Bogen längs x steigt um dies, oder hängt, wo es negativ ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along y rises by this, or hangs where it is negative</source>
   <translation>Der Bogen längs y steigt um dies, oder hängt, wo es negativ ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The border is left a zigzag, or closed by narrow quads</source>
   <translation>Der Rand bleibt ein Zickzack oder wird mit schmalen Vierecken geschlossen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The cables have this force density, force / length</source>
   <translation>Die Seile haben diese Kraftdichte, Kraft / Länge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>The check as JSON</source>
   <translation>Die Prüfung als JSON</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The curve goes through these points instead, about the centre</source>
   <translation>Die Kurve geht stattdessen durch diese Punkte, um die Mitte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The edges carry this load, force / mm</source>
   <translation>Die Kanten tragen diese Last, Kraft / mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The ends of a curve that is no preset are joined</source>
   <translation>Die Enden einer Kurve, die keine Vorgabe ist, werden verbunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this load, force / mm2</source>
   <translation>Die Flächen tragen diese Last, Kraft / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this pressure along their normals, force / mm2</source>
   <translation>Die Flächen tragen diesen Druck längs ihrer Normalen, Kraft / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The families u and v change places</source>
   <translation>Die Scharen u und v tauschen ihre Plätze</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of the two holds the first vertex</source>
   <translation>Das erste der beiden enthält die erste Ecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of them follows this formula of s</source>
   <translation>Die erste davon folgt dieser Formel von s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix has this radius</source>
   <translation>Die Schraubenlinie hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix turns by this angle</source>
   <translation>Die Schraubenlinie dreht sich um diesen Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The imperfection is this large; 0 is 1/300 of the second longest side of the box</source>
   <translation>Die Imperfektion ist so groß; 0 heißt 1/300 der zweitlängsten Seite der Hülle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The inversion has its centre here</source>
   <translation>Die Inversion hat hier ihr Zentrum</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The largest displacement that passes is this part of the second longest side of the net's box: 200 for 1/200</source>
   <translation>Die größte Verschiebung, die besteht, ist dieser Teil der zweitlängsten Seite der Box des Netzes: 200 für 1/200</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The last point is joined with the first</source>
   <translation>Der letzte Punkt wird mit dem ersten verbunden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>The loads count so many times; 0 leaves them out</source>
   <translation>So viele Male zählen die Lasten; 0 lässt sie weg</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The lower end has this radius</source>
   <translation>Das untere Ende hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members are made of this</source>
   <translation>Die Stäbe sind hieraus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members have this profile; groups another one after it, as tube:100x60x5,border=tube:120x60x5</source>
   <translation>Die Stäbe haben dieses Profil; Gruppen dahinter ein anderes, wie tube:100x60x5,border=tube:120x60x5</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane has this stress, force / length</source>
   <translation>Die Membran hat diese Spannung, Kraft / Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane's border cable has this force</source>
   <translation>Das Randseil der Membran hat diese Kraft</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The middle of sections lies this far above the net, along its axes</source>
   <translation>Die Mitte der Querschnitte liegt so weit über dem Netz, längs seiner Achsen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror image comes alone</source>
   <translation>Das Spiegelbild kommt allein</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane goes through this point</source>
   <translation>Die Spiegelebene geht durch diesen Punkt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane has this normal</source>
   <translation>Die Spiegelebene hat diese Normale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The multi-net guide keeps patches of so many faces along and across orthogonal</source>
   <translation>Die Multinetz-Führung hält Stücke von so vielen Flächen längs und quer orthogonal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The narrowest circle has this radius</source>
   <translation>Der engste Kreis hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of u</source>
   <translation>Das Netz bedeckt diesen Teil des Bereichs von u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of v</source>
   <translation>Das Netz bedeckt diesen Teil des Bereichs von v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net follows these lines of the surface</source>
   <translation>Das Netz folgt diesen Linien der Fläche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these angles about the axis</source>
   <translation>Das Netz geht vom ersten zum zweiten dieser Winkel um die Achse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these latitudes</source>
   <translation>Das Netz geht vom ersten zum zweiten dieser Breitengrade</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t of the confocal family</source>
   <translation>Das Netz geht vom ersten zum zweiten t der konfokalen Schar</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t; with 0 and 0 it keeps clear of both ends</source>
   <translation>Das Netz geht vom ersten zum zweiten t; mit 0 und 0 hält es Abstand von beiden Enden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes on along these axes as its mirror image, as x,y</source>
   <translation>Das Netz geht längs dieser Achsen als sein Spiegelbild weiter, wie x,y</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is its own mirror image in these planes: auto for those that the surface has, or those across an axis, through the middle of the surface</source>
   <translation>Das Netz ist sein eigenes Spiegelbild in diesen Ebenen: auto für die der Fläche, oder die quer zu einer Achse, durch die Mitte der Fläche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is made of cables, or is a membrane of one stress</source>
   <translation>Das Netz ist aus Seilen oder eine Membran gleicher Spannung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is moved by this</source>
   <translation>Das Netz wird um dies verschoben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is scaled by this factor</source>
   <translation>Das Netz wird mit diesem Faktor skaliert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this long along x</source>
   <translation>Das Netz ist längs x so lang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this wide across</source>
   <translation>Das Netz ist quer so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is to become this one; asymptotic and cmc lines run at 45 degrees to curvature, those of asymptotic-angle where the surface does not bend, stress lines as a shell carries its weight</source>
   <translation>Das Netz soll dieses werden; asymptotische und cmc-Linien laufen 45 Grad zur Krümmung, die von asymptotic-angle in Richtungen, in denen sich die Fläche nicht krümmt, Spannungslinien so, wie eine Schale ihr Gewicht trägt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is turned by these angles about x, then y, then z</source>
   <translation>Das Netz wird um diese Winkel um x, dann y, dann z gedreht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches so far over the surface, farther where this is larger</source>
   <translation>Das Netz reicht so weit über die Fläche, weiter, wo dies größer ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches this far from the axis on both sides</source>
   <translation>Das Netz reicht auf beiden Seiten so weit von der Achse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net runs along these lines, drawn on the surface</source>
   <translation>Das Netz läuft längs dieser auf die Fläche gezeichneten Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net stands here, turned like this</source>
   <translation>Das Netz steht hier, so gedreht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>The net that optimising and editing aim at</source>
   <translation>Das Netz, auf das Optimieren und Bearbeiten zielen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The offset lies this far along the normals, below where it is negative</source>
   <translation>Der Versatz liegt so weit längs der Normalen, darunter, wo es negativ ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The other side is turned up</source>
   <translation>Die andere Seite wird nach oben gedreht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>The other side is up than where the net came from</source>
   <translation>Die andere Seite ist oben als dort, woher das Netz kam</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline goes through these points, in the frame of the quadric</source>
   <translation>Der Streckenzug geht durch diese Punkte, im System der Quadrik</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline lies on this quadric</source>
   <translation>Der Streckenzug liegt auf dieser Quadrik</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The result may be this far off the surface, or the start where none is given; 0 is not limited</source>
   <translation>Das Ergebnis darf so weit von der Fläche entfernt sein, oder vom Start, wo keine angegeben ist; 0 heißt unbegrenzt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The second of them follows this formula of s</source>
   <translation>Die zweite davon folgt dieser Formel von s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes are this long, the largest comes first</source>
   <translation>Die Halbachsen sind so lang, die größte kommt zuerst</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of lambda = 0 are this long, the largest comes first</source>
   <translation>Die Halbachsen von lambda = 0 sind so lang, die größte kommt zuerst</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of the quadric are this long</source>
   <translation>Die Halbachsen der Quadrik sind so lang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>The shape waits to be built anew</source>
   <translation>Die Form wartet darauf, neu gebaut zu werden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>The source has changed since the vertices were moved; optimise again</source>
   <translation>Die Quelle hat sich geändert, seit die Ecken bewegt wurden; neu optimieren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has its centre here</source>
   <translation>Die Kugel hat hier ihre Mitte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has this radius</source>
   <translation>Die Kugel hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface grows in proportion to this length</source>
   <translation>Die Fläche wächst im Verhältnis zu dieser Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has so many waves along its axis</source>
   <translation>Die Fläche hat längs ihrer Achse so viele Wellen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has this radius</source>
   <translation>Die Fläche hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface is this high</source>
   <translation>Die Fläche ist so hoch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The tangents of these points make the sheet; empty for a helix</source>
   <translation>Die Tangenten an diesen Punkten bilden die Fläche; leer für eine Schraubenlinie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two directions meet at this angle; 0 is as the net has it</source>
   <translation>Die beiden Richtungen treffen sich in diesem Winkel; 0 heißt wie das Netz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates follow this curve</source>
   <translation>Die beiden anderen Koordinaten folgen dieser Kurve</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates have these values instead</source>
   <translation>Die beiden anderen Koordinaten haben stattdessen diese Werte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The upper end has this radius</source>
   <translation>Das obere Ende hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The weight of the members is a load</source>
   <translation>Das Gewicht der Stäbe ist eine Last</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The widest circle has this radius</source>
   <translation>Der weiteste Kreis hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>The wind has this pressure in kN/m2 and blows this way, as 0.6@x; a case each</source>
   <translation>Der Wind hat diesen Druck in kN/m2 und weht dorthin, wie 0.6@x; je ein Lastfall</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>There may be so many kinds; 0 is as few as can be found</source>
   <translation>So viele Arten darf es geben; 0 heißt so wenige wie möglich</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or numbers of vertices, each with :pinned, :fixed, :sliding (up and down only) or :springs=X/Y/Z (kN/mm), joined by +</source>
   <translation>Dies wird gehalten: boundary, corners oder Nummern von Ecken, jeweils mit :pinned, :fixed, :sliding (nur auf und ab) oder :springs=X/Y/Z (kN/mm), mit + verbunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or vertices as 0,5,12</source>
   <translation>Dies wird gehalten: boundary, corners oder Ecken wie 0,5,12</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These lines lie in planes of their own</source>
   <translation>Diese Linien liegen in eigenen Ebenen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These points (radius, height) are turned about z</source>
   <translation>Diese Punkte (Radius, Höhe) werden um z gedreht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These supports are raised first, VERTEX:HEIGHT in mm as 0:1500; 20:900</source>
   <translation>Diese Auflager werden zuerst angehoben, ECKE:HÖHE in mm wie 0:1500; 20:900</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>These vertices carry these forces in kN, as 12:0,0,-5</source>
   <translation>Diese Ecken tragen diese Kräfte in kN, wie 12:0,0,-5</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Thickness: the plates are this thick</source>
   <translation>Dicke: die Bleche sind so dick</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This elliptic coordinate has the role of t</source>
   <translation>Diese elliptische Koordinate hat die Rolle von t</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This part of the range is left free at each end</source>
   <translation>Dieser Teil des Bereichs bleibt an jedem Ende frei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This point stays where it is</source>
   <translation>Dieser Punkt bleibt, wo er ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Through: plates of this family run through where two cross, both by half laps</source>
   <translation>Durchlaufend: Platten dieser Familie laufen durch, wo zwei sich kreuzen, beide mit Überblattung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tilt: the louvres are turned by this angle about their lines</source>
   <translation>Neigung: die Sonnenlamellen sind um diesen Winkel um ihre Linien gedreht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Trim: the stock loses this much at each end</source>
   <translation>Anschnitt: die Lagerlänge verliert so viel an jedem Ende</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Unit of the file that the net came from</source>
   <translation>Einheit der Datei, aus der das Netz kam</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Unrolled axes pass that are off straight by this at most; 0: any</source>
   <translation>Abgewickelte Achsen bestehen, die höchstens so weit von gerade abweichen; 0: beliebig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Unrolled axes pass that are off their arc by this at most; 0: any</source>
   <translation>Abgewickelte Achsen bestehen, die höchstens so weit von ihrem Bogen abweichen; 0: beliebig</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Utilisation of each member, 1 is all</source>
   <translation>Ausnutzung jedes Stabs, 1 ist alles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/properties.py" />
   <source>Version of this object's properties</source>
   <translation>Version der Eigenschaften dieses Objekts</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Vertex numbers of the quads, four a face</source>
   <translation>Eckennummern der Vierecke, vier je Masche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices that are nearer than this are merged</source>
   <translation>Ecken, die näher als dies sind, werden vereinigt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Vertices that do not move</source>
   <translation>Ecken, die sich nicht bewegen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices, edges or faces keep the distance, or edges stay parallel</source>
   <translation>Ecken, Kanten oder Flächen halten den Abstand, oder Kanten bleiben parallel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>What each part exceeds, 'ok' if nothing</source>
   <translation>Was jedes Teil überschreitet, 'ok' wenn nichts</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>What is to be known about the net as it was made</source>
   <translation>Was über das Netz, wie es gemacht wurde, zu wissen ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>What is to be known before the shape is used</source>
   <translation>Was zu wissen ist, bevor die Form verwendet wird</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>What is to be known of the model</source>
   <translation>Was vom Modell zu wissen ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>What the check comes to, in one line</source>
   <translation>Was die Prüfung ergibt, in einer Zeile</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>What the colours of the members say</source>
   <translation>Was die Farben der Stäbe sagen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>What the net is built with</source>
   <translation>Womit das Netz gebaut wird</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>What the net is made by</source>
   <translation>Wodurch das Netz gemacht ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>What the picture shows of them</source>
   <translation>Was das Bild von ihnen zeigt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>What was taken off the coordinates of a file far from the origin; export puts it back</source>
   <translation>Was von den Koordinaten einer Datei weit vom Ursprung abgezogen wurde; der Export fügt es wieder hinzu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Where lines u and v cross, in slots of one layer or about the bolts of two, they turn like this about their axis: rigid, hinged, or the stiffness of a spring in kNm/rad</source>
   <translation>Wo Linien u und v sich kreuzen, in Schlitzen einer Lage oder um die Schrauben von zweien, drehen sie sich so um ihre Achse: rigid, hinged oder die Steifigkeit einer Feder in kNm/rad</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Where the height of the members' sections points to</source>
   <translation>Wohin die Höhe der Querschnitte zeigt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Where the names stand</source>
   <translation>Wo die Namen stehen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Where the shape stands while nobody has moved it</source>
   <translation>Wo die Form steht, solange niemand sie bewegt hat</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Whether all that was checked holds</source>
   <translation>Ob alles hält, was geprüft wurde</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Which vertices glide on each: their numbers, empty for those near it</source>
   <translation>Welche Ecken auf jeder gleiten: ihre Nummern, leer für die nahen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Width of a sheet; 0: the parts lie in rows</source>
   <translation>Breite einer Tafel; 0: die Teile liegen in Reihen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Width of the edges in pixels</source>
   <translation>Breite der Kanten in Pixeln</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Width of the members, in pixels</source>
   <translation>Breite der Stäbe, in Pixeln</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Width: the strips are this wide</source>
   <translation>Breite: die Streifen sind so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>another number begins another search for a dense nesting</source>
   <translation>eine andere Zahl beginnt eine andere Suche nach dichter Schachtelung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>boxes pack fast, outlines densely</source>
   <translation>Rahmen packen schnell, Umrisse dicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>outlines grow by half this width of a cut</source>
   <translation>Umrisse wachsen um die halbe Breite der Schnittfuge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts keep so far from each other and from the rim</source>
   <translation>so weit bleiben Teile voneinander und vom Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts may turn on the sheet as its grain says</source>
   <translation>Teile drehen sich auf der Tafel, wie ihre Faserrichtung es erlaubt</translation>
  </message>
 </context>
 <context>
  <name>Ortho</name>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>, drawn {:g} times</source>
   <translation>, {:g}-fach gezeichnet</translation>
  </message>
  <message>
   <location filename="../../../solver/align/align.py" />
   <source>1 face is folded; give a shorter edge, or smooth the surface there</source>
   <translation>1 Masche ist gefaltet; eine kürzere Kante angeben oder die Fläche dort glätten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>1 mm, slots by material</source>
   <translation>1 mm, Schlitze je Material</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/mirror.py" />
   <source>1 vertex merged</source>
   <translation>1 Ecke vereinigt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/aligning.py" />
   <source>1 vertex with {} lines</source>
   <translation>1 Ecke mit {} Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>1/1000 of an edge</source>
   <translation>1/1000 der Kante</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>1/300 of the second longest side of the box</source>
   <translation>1/300 der zweitlängsten Seite der Hülle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>100 mm, of bolted ones what each needs</source>
   <translation>100 mm, geschraubte so groß wie nötig</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>A click marks the worst place, a double click shows the measure in colours.</source>
   <translation>Ein Klick markiert die schlechteste Stelle, ein Doppelklick zeigt das Maß in Farben.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface of geodesic squares.</source>
   <translation>Eine abwickelbare Fläche aus geodätischen Quadraten.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface of squares, all edges equal.</source>
   <translation>Eine abwickelbare Fläche aus Quadraten, alle Kanten gleich.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface, by the stricter definition.</source>
   <translation>Eine abwickelbare Fläche, nach der strengeren Definition.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface: it is bent from flat sheet.</source>
   <translation>Eine abwickelbare Fläche: aus ebenem Blech gebogen.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>A list, or sections joined by +</source>
   <translation>Eine Liste oder Querschnitte, verbunden durch +</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A membrane or cable net in equilibrium with its supports and loads</source>
   <translation>Eine Membran oder ein Seilnetz im Gleichgewicht mit Lagern und Lasten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A minimal surface with straight upright lamellas.</source>
   <translation>Eine Minimalfläche mit geraden, aufrechten Lamellen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A net along lines of curvature of CAD faces, or at 45 degrees to them</source>
   <translation>Ein Netz entlang der Krümmungslinien von CAD-Flächen oder unter 45 Grad zu ihnen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>A net that came from far away lies about a point nearby, where CAD kernels keep their accuracy; its file's coordinates are put back on demand.</source>
   <translation>Ein Netz, das von weit her kam, liegt um einen nahen Punkt, wo CAD-Kerne genau bleiben; die Koordinaten seiner Datei kommen auf Verlangen zurück.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A parallel net at a distance that is constant where the net allows it</source>
   <translation>Ein paralleles Netz in einem Abstand, der konstant ist, wo das Netz es zulässt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Add</source>
   <translation>Hinzufügen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Add points</source>
   <translation>Punkte hinzufügen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/advanced_box.py" />
   <source>Advanced</source>
   <translation>Erweitert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Alike to</source>
   <translation>Winkel auf</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Alike within</source>
   <translation>Gleich auf</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>All parts are made of this.</source>
   <translation>Alle Teile sind hieraus.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Along</source>
   <translation>Entlang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Also write</source>
   <translation>Auch schreiben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Analysis added; the FEM workbench solves it</source>
   <translation>Analyse angelegt; der FEM-Arbeitsbereich löst sie</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Analysis of the FEM workbench</source>
   <translation>Analyse des FEM-Arbeitsbereichs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Anchor</source>
   <translation>Anker</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Angles</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Area load</source>
   <translation>Flächenlast</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Arms</source>
   <translation>Arme</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Arms beside the net</source>
   <translation>Arme neben dem Netz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Arrow on the upper side</source>
   <translation>Pfeil auf der Oberseite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Asked</source>
   <translation>Verlangt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Assemblies in IFC</source>
   <translation>Baugruppen in IFC</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Assembly</source>
   <translation>Montage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Asymptotic</source>
   <translation>Asymptotisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Asymptotic diagonals</source>
   <translation>Asymptotische Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>At</source>
   <translation>Bei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At hubs</source>
   <translation>An Naben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the larger one</source>
   <translation>In ihrem Scheitel hat die Fläche diesen Krümmungsradius, den größeren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the smaller one</source>
   <translation>In ihrem Scheitel hat die Fläche diesen Krümmungsradius, den kleineren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At the border</source>
   <translation>Am Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At the border the net overhangs the surface, to be trimmed, or bends to follow it</source>
   <translation>Am Rand ragt das Netz über die Fläche hinaus, um beschnitten zu werden, oder biegt sich ihm entlang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Axial force</source>
   <translation>Normalkraft</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Axial forces</source>
   <translation>Normalkräfte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>BTLx says how parts of timber are cut, drilled and marked</source>
   <translation>BTLx sagt, wie Teile aus Holz geschnitten, gebohrt und angerissen werden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>Bake</source>
   <translation>Festschreiben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Balance is found in the deformed, imperfect shape</source>
   <translation>Das Gleichgewicht wird in der verformten, unvollkommenen Form gefunden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Begin a new polyline: click its points on the quadric.</source>
   <translation>Einen neuen Linienzug beginnen: seine Punkte auf der Quadrik anklicken.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bend radius</source>
   <translation>Biegeradius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bending</source>
   <translation>Biegung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bending radius</source>
   <translation>Biegeradius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bent so that circles stay circles; place and size stay</source>
   <translation>So gebogen, dass Kreise Kreise bleiben; Ort und Größe bleiben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Beside what it is off right angles, which all these nets ask for.</source>
   <translation>Neben dem, was ihm zu rechten Winkeln fehlt, die alle diese Netze verlangen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bite</source>
   <translation>Fugenbreite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolt</source>
   <translation>Schraube</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolts</source>
   <translation>Schrauben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border</source>
   <translation>Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cables have this force density; 0 is the same</source>
   <translation>Randseile haben diese Kraftdichte; 0 heißt dieselbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cut</source>
   <translation>Randschnitt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border density</source>
   <translation>Randdichte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border force</source>
   <translation>Randkraft</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bore</source>
   <translation>Bohrung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Buckling length</source>
   <translation>Knicklänge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Buckling shape {}</source>
   <translation>Knickform {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>C24</source>
   <translation>C24</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>C30</source>
   <translation>C30</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CAD faces sampled along their own parameter lines</source>
   <translation>CAD-Flächen, längs ihrer eigenen Parameterlinien abgetastet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC</source>
   <translation>CMC</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC diagonals</source>
   <translation>CMC, Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC nets: the vertex spheres have this radius</source>
   <translation>CMC-Netze: Die Eckenkugeln haben diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Catenoid around z, from -height / 2 to height / 2.</source>
   <translation>Katenoid um z, von -Höhe / 2 bis Höhe / 2.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Centre</source>
   <translation>Mitte</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/sources.py" />
   <source>Change source</source>
   <translation>Quelle ändern</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/common.py" />
   <source>Change {}</source>
   <translation>{} ändern</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev</source>
   <translation>Tschebyschow</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev diagonals</source>
   <translation>Tscheb. diagonal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: each direction has a length of its own</source>
   <translation>Tschebyschow-Netze: jede Richtung hat ihre eigene Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: the edges are this long</source>
   <translation>Tschebyschow-Netze: Die Kanten sind so lang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev: equal edges</source>
   <translation>Tschebyschow: Rauten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Check</source>
   <translation>Prüfen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>Choose the recommended net.</source>
   <translation>Das empfohlene Netz wählen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Christoffel dual</source>
   <translation>Christoffel-Dual</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular</source>
   <translation>Zirkular</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular arch moved along another one; negative rises hang.</source>
   <translation>Kreisbogen, längs eines anderen verschoben; negative Stiche hängen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular cone around z, cut off at the top, rulings along v; isosceles trapezoids.</source>
   <translation>Kreiskegel um z, oben abgeschnitten, Erzeugende längs v; gleichschenklige Trapeze.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular cylinder around z, rulings along v; faces are rectangles.</source>
   <translation>Kreiszylinder um z, Erzeugende längs v; die Maschen sind Rechtecke.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clear</source>
   <translation>Leeren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clear distance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clearance</source>
   <translation>Spiel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cleats</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>Click edges in the 3D view, or wires and sketches in the tree, that lines of the net run along; a second click leaves them out.</source>
   <translation>Klicken Sie Kanten in der 3D-Ansicht oder Kantenzüge und Skizzen im Baum an, an denen Linien des Netzes entlanglaufen; ein zweiter Klick lässt sie weg.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click edges, faces or planes that the boundary near them (on a curved face: every vertex) glides on, exactly.</source>
   <translation>Kanten, Flächen oder Ebenen anklicken, auf denen der Rand in ihrer Nähe (auf gekrümmter Fläche: jede Ecke) exakt gleitet.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click faces that the net stays near as far as it can.</source>
   <translation>Flächen anklicken, denen das Netz so nahe bleibt, wie es kann.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Click points on the quadric; right click or Esc ends.</source>
   <translation>Punkte auf der Quadrik anklicken; Rechtsklick oder Esc beendet.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/form_panel.py" />
   <source>Click vertices in the 3D view to hold them; click again to free.</source>
   <translation>Ecken in der 3D-Ansicht anklicken, um sie zu halten; noch einmal, um sie zu lösen.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click vertices that are held softly, or drag them to a place.</source>
   <translation>Ecken anklicken, die weich gehalten werden, oder an einen Ort ziehen.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click vertices that must not move; a second click frees them.</source>
   <translation>Ecken anklicken, die sich nicht bewegen dürfen; ein zweiter Klick löst sie.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Clicks add points at the end; Backspace takes the last one away.</source>
   <translation>Klicks fügen am Ende Punkte an; die Rücktaste nimmt den letzten weg.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Close</source>
   <translation>Schließen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Close the open task panel first.</source>
   <translation>Schließen Sie zuerst das offene Aufgabenfenster.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Closed</source>
   <translation>Geschlossen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Closeness</source>
   <translation>Nähe</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Colour map</source>
   <translation>Farbkarte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Confocal ellipses x^2/(a + t) + y^2/(b + t) = 1 and their hyperbolas, flat; a multi-net.</source>
   <translation>Konfokale Ellipsen x^2/(a + t) + y^2/(b + t) = 1 und ihre Hyperbeln, eben; ein Multinetz.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Conical</source>
   <translation>Konisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Constant mean curvature; lamellas unroll to equal arcs.</source>
   <translation>Konstante mittlere Krümmung; Lamellen wickeln zu gleichen Bögen ab.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Constraints</source>
   <translation>Bedingungen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Coordinates</source>
   <translation>Koordinaten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Corner</source>
   <translation>Ecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cross rise</source>
   <translation>Querstich</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Crossings</source>
   <translation>Kreuzungen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Curvature lines of an ellipsoid around its longest axis, closed in u.</source>
   <translation>Krümmungslinien eines Ellipsoids um seine längste Achse, in u geschlossen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Curvature lines of z = x^2 / (2 first) + y^2 / (2 second) over the quarter x, y &gt; 0.</source>
   <translation>Krümmungslinien von z = x^2 / (2 erster) + y^2 / (2 zweiter) über dem Viertel x, y &gt; 0.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Curve</source>
   <translation>Kurve</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cutter</source>
   <translation>Fräser</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>DXF drawings</source>
   <translation>DXF-Zeichnungen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>DXF version</source>
   <translation>DXF-Version</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Date</source>
   <translation>Datum</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Deflected shape</source>
   <translation>Verformte Gestalt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Deflection</source>
   <translation>Durchbiegung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Density</source>
   <translation>Dichte</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Diagonals</source>
   <translation>Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Displacement</source>
   <translation>Verschiebung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/display.py" />
   <source>Display</source>
   <translation>Anzeige</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Distance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Distortion</source>
   <translation>Verzerrung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Drag</source>
   <translation>Ziehen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Drag a vertex. Click: choose; Ctrl: several; Shift and drag: all in a frame; Del: no handle any more; Esc: put back. Handles that are not dragged stay exactly where they are. Each drag is one step for Undo.</source>
   <translation>Eine Ecke ziehen. Klick: wählen; Strg: mehrere; Umschalt und ziehen: alle in einem Rahmen; Entf: kein Griff mehr; Esc: zurück. Griffe, die nicht gezogen werden, bleiben genau, wo sie sind. Jedes Ziehen ist ein Schritt für Rückgängig.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Drag the points along the surface; dropped onto each other, one with 3 and one with 5 lines vanish, and two with 5 become one with 6</source>
   <translation>Ziehen Sie die Punkte auf der Fläche; aufeinander abgelegt verschwinden einer mit 3 und einer mit 5 Linien, und zwei mit 5 werden einer mit 6</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Drag vertices</source>
   <translation>Ecken ziehen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Draw</source>
   <translation>Zeichnen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>Drawing page</source>
   <translation>Zeichnungsblatt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>Drawing pages</source>
   <translation>Zeichnungsblätter</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Drawings</source>
   <translation>Zeichnungen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Drawn strokes</source>
   <translation>Gezeichnete Kurven</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Dual ratio</source>
   <translation>Dualverhältnis</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Each vertex carries this load, a force along x, y and z</source>
   <translation>Jede Ecke trägt diese Last, eine Kraft längs x, y und z</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Each vertex lies on one sphere with its neighbours.</source>
   <translation>Jede Ecke liegt mit ihren Nachbarn auf einer Kugel.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Eccentric</source>
   <translation>Exzentrisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge</source>
   <translation>Kante</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge cover</source>
   <translation>Einstand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge height</source>
   <translation>Randhöhe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge length</source>
   <translation>Kantenlänge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge load</source>
   <translation>Kantenlast</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge section</source>
   <translation>Randprofil</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge vectors</source>
   <translation>Kantenvektoren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge wall</source>
   <translation>Rohrwand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge width</source>
   <translation>Randbreite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges</source>
   <translation>Kanten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges along the principal stresses, in equilibrium.</source>
   <translation>Kanten längs der Hauptspannungen, im Gleichgewicht.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long</source>
   <translation>Kanten sind etwa so lang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long, whatever the sampling</source>
   <translation>Kanten sind etwa so lang, gleich welche Abtastung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of nodes may be turned this far from the shape of their kind</source>
   <translation>Kanten von Knoten dürfen so weit von der Form ihrer Art verdreht sein</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of the other family of lines are so many times as long</source>
   <translation>Kanten der anderen Linienschar sind so viele Male so lang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Edit net</source>
   <translation>Netz bearbeiten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Edit settings</source>
   <translation>Einstellungen bearbeiten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/source_net_view.py" />
   <source>Edit source</source>
   <translation>Quelle bearbeiten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends</source>
   <translation>Enden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends of members are rigid, hinged, or have springs of this stiffness in kNm/rad</source>
   <translation>Stabenden sind starr, gelenkig oder haben Federn dieser Steifigkeit in kNm/rad (rigid, hinged oder die Zahl)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Enneper's surface over the square |u|, |v| &lt;= reach (turned by 45 degrees for asymptotic).</source>
   <translation>Enneper-Fläche über dem Quadrat |u|, |v| &lt;= Reichweite (für asymptotisch um 45 Grad gedreht).</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal</source>
   <translation>Gleich</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal angles</source>
   <translation>Gleiche Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal angles diagonals</source>
   <translation>Gleiche Winkel, Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal in STEP</source>
   <translation>Gleich in STEP</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Even angle</source>
   <translation>Gleicher Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Even angle diagonals</source>
   <translation>Gleicher Winkel der Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Evenness</source>
   <translation>Gleichmaß</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every</source>
   <translation>Jede</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every k-th parameter line</source>
   <translation>Jede k-te Parameterlinie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every so many lines of u and v stay</source>
   <translation>Jede so vielte Linie von u und v bleibt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Export fabrication files</source>
   <translation>Fertigungsdateien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/fem_analyses.py" />
   <source>FEM analysis</source>
   <translation>FEM-Analyse</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Fabrication files written to {}</source>
   <translation>Fertigungsdateien geschrieben nach {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces at inner irregular vertices are left out, or asked for right angles too, which no smooth surface has there</source>
   <translation>Flächen an inneren irregulären Ecken bleiben aus, oder auch von ihnen werden rechte Winkel verlangt, die dort keine glatte Fläche hat</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces keep the shape they have: paper that is bent.</source>
   <translation>Maschen behalten ihre Form: Papier, das gebogen wird.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces keep their shape the more of it there is, such as 10; none is usual</source>
   <translation>Je mehr davon, desto mehr behalten Flächen ihre Form, etwa 10; üblich ist keines</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Fairness</source>
   <translation>Glattheit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Few kinds</source>
   <translation>Wenige Arten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Few kinds are wanted of these parts, once the net is reached</source>
   <translation>Von diesen Teilen sind wenige Arten gewünscht, sobald das Netz erreicht ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Files of the check written to {}</source>
   <translation>Dateien der Prüfung in {} geschrieben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Find the lightest section</source>
   <translation>Leichtesten Querschnitt suchen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>Finding the exact net ...</source>
   <translation>Das exakte Netz wird gesucht ...</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structural_checks.py" />
   <source>Finding the lightest section</source>
   <translation>Suche nach dem leichtesten Querschnitt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>First</source>
   <translation>Erster</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>First formula</source>
   <translation>Erste Formel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Fix</source>
   <translation>Festhalten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flange thickness</source>
   <translation>Flanschdicke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces of any angles, near the surface that was drawn.</source>
   <translation>Ebene Flächen mit beliebigen Winkeln, nahe an der entworfenen Fläche.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces of steady proportions, and a dual net with parallel edges.</source>
   <translation>Ebene Flächen mit stetigen Proportionen und ein duales Netz mit parallelen Kanten.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces with an exact offset at constant thickness.</source>
   <translation>Ebene Maschen mit exaktem Versatz konstanter Dicke.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces with right angles; torsion-free beams.</source>
   <translation>Ebene Maschen mit rechten Winkeln; torsionsfreie Träger.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces, and lines that lie in planes of their own.</source>
   <translation>Ebene Flächen, und Linien, die in eigenen Ebenen liegen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces, each with a circle through its corners.</source>
   <translation>Ebene Maschen, jede mit einem Kreis durch ihre Ecken.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat net in the plane z = 0, centred at the origin; rectangles, normals along +z.</source>
   <translation>Ebenes Netz in z = 0, mittig im Ursprung; Rechtecke, Normalen längs +z.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/flat_patterns.py" />
   <source>Flat patterns</source>
   <translation>Abwicklungen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flatness</source>
   <translation>Ebenheit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Flip net</source>
   <translation>Netz wenden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Fold</source>
   <translation>Kantung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Folder for the fabrication files</source>
   <translation>Ordner für die Fertigungsdateien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot at</source>
   <translation>Füße an</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot height</source>
   <translation>Fußhöhe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot plate</source>
   <translation>Fußplatte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>For buckling and second order each member has so many pieces</source>
   <translation>Für Knicken und zweite Ordnung hat jeder Stab so viele Stücke</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>For developable nets: the sheet bends and hardly stretches.</source>
   <translation>Für abwickelbare Netze: das Blech biegt sich und dehnt sich kaum.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Force</source>
   <translation>Kraft</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Forces</source>
   <translation>Kräfte</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Forces under equal loads</source>
   <translation>Kräfte bei gleicher Last</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Four faces for each, parameter lines kept</source>
   <translation>Vier Maschen aus jeder, Parameterlinien bleiben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame</source>
   <translation>Rahmen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame width</source>
   <translation>Rahmenbreite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>FreeCAD's Python was not found, or it has no pip. Install pip for Python {} with your system's package manager, then try again.</source>
   <translation>Das Python von FreeCAD wurde nicht gefunden oder hat kein pip. Installieren Sie pip für Python {} mit der Paketverwaltung Ihres Systems und versuchen Sie es dann noch einmal.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>From</source>
   <translation>Von</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>GL24h</source>
   <translation>GL24h</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>GL28h</source>
   <translation>GL28h</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>GL30h</source>
   <translation>GL30h</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>GL32h</source>
   <translation>GL32h</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gap</source>
   <translation>Fuge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gap to reference</source>
   <translation>Abstand zur Vorlage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gasket</source>
   <translation>Dichtung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gauss curvature</source>
   <translation>Gaußsche Krümmung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Gauss image</source>
   <translation>Gaußsches Bild</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Geodesic</source>
   <translation>Geodätisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Geodesic diagonals</source>
   <translation>Geodätische Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Glide</source>
   <translation>Gleiten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Glide on ...</source>
   <translation>Gleiten auf ...</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Grain</source>
   <translation>Faserrichtung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Handle</source>
   <translation>Griff</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Handles</source>
   <translation>Griffe</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>Hardly possible: {}</source>
   <translation>Kaum möglich: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hardware in STEP</source>
   <translation>Kleinteile in STEP</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Have them found: the fewest that the surface needs.</source>
   <translation>Sie finden lassen: die wenigsten, die die Fläche braucht.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Height</source>
   <translation>Höhe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Helicoid around z, radii from -radius to radius.</source>
   <translation>Helikoid um z, Radien von -Radius bis Radius.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Hold</source>
   <translation>Halten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hole</source>
   <translation>Loch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>How many lines meet in the one to be added.</source>
   <translation>Wie viele Linien sich in der treffen, die dazukommt.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub diameter</source>
   <translation>Nabendurchmesser</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub wall</source>
   <translation>Nabenwand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>I</source>
   <translation>I</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>IFC 4 holds all parts, with quantities and properties</source>
   <translation>IFC 4 enthält alle Teile, mit Mengen und Eigenschaften</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Image only</source>
   <translation>Nur Bild</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Imperfection</source>
   <translation>Imperfektion</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Import quad mesh</source>
   <translation>Vierecksnetz importieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Install</source>
   <translation>Installieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Installed, but Python does not find it in {}.</source>
   <translation>Installiert, aber Python findet es nicht in {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Installed. Start FreeCAD again to use everything.</source>
   <translation>Installiert. Starten Sie FreeCAD neu, um alles zu nutzen.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Installing {}. This takes some minutes.</source>
   <translation>{} wird installiert. Das dauert einige Minuten.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Inverted in a sphere</source>
   <translation>An einer Kugel invertiert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Irregular</source>
   <translation>Irreguläre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Irregular vertices</source>
   <translation>Irreguläre Ecken</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Isometric</source>
   <translation>Isometrisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Isometric nets: faces keep the shape that this net has; empty: as it starts</source>
   <translation>Isometrische Netze: Flächen behalten die Form, die dieses Netz hat; leer: wie es beginnt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Isometry</source>
   <translation>Isometrie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>It is asked of the diagonals of the faces, not of the edges</source>
   <translation>Verlangt wird es von den Diagonalen der Flächen, nicht von den Kanten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Joints</source>
   <translation>Anschlüsse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>K factor</source>
   <translation>k-Faktor</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Keep border</source>
   <translation>Rand behalten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Keep the last line where the step misses it</source>
   <translation>Die letzte Linie behalten, wo der Schritt sie verfehlt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kerf</source>
   <translation>Schnittfuge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kind</source>
   <translation>Art</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds</source>
   <translation>Arten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds of edges</source>
   <translation>Arten von Kanten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds of nodes</source>
   <translation>Arten von Knoten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds of panels</source>
   <translation>Arten von Paneelen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Label sheet</source>
   <translation>Etikettenbogen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Labels</source>
   <translation>Etiketten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Latitudes</source>
   <translation>Breiten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Layers</source>
   <translation>Lagen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Layout</source>
   <translation>Anordnung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least length</source>
   <translation>Mindestlänge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least rest</source>
   <translation>Kleinster Rest</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least width</source>
   <translation>Mindestbreite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Lengths are in mm, curvatures in 1/m, angles in degrees.</source>
   <translation>Längen sind in mm, Krümmungen in 1/m, Winkel in Grad.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Less than 1 moves the centre farther away</source>
   <translation>Weniger als 1 rückt das Zentrum weiter weg</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Let the shape swing</source>
   <translation>Die Form schwingen lassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Levels</source>
   <translation>Stufen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Lie on</source>
   <translation>Liegen auf</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lift</source>
   <translation>Anheben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Line elements of the members</source>
   <translation>Linienelemente der Stäbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Line planes</source>
   <translation>Ebenen der Linien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Lines</source>
   <translation>Linien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Lines of the members</source>
   <translation>Linien der Stäbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines stand at even distances, or at equal steps of the parameters</source>
   <translation>Linien stehen in gleichen Abständen oder gleichen Schritten der Parameter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines that all cross at one angle, faces not flat.</source>
   <translation>Linien, die sich alle unter einem Winkel kreuzen, Flächen nicht eben.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines that cross at right angles, faces not flat.</source>
   <translation>Linien, die sich rechtwinklig kreuzen, Maschen nicht eben.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u and v lie in two layers, u above, the middles of their sections this far apart</source>
   <translation>Linien u und v liegen in zwei Lagen, u oben, die Mitten ihrer Querschnitte so weit auseinander</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u, lines v and diagonals of a web are these: a asymptotic, g geodesic</source>
   <translation>Linien u, Linien v und Diagonalen eines Gewebes sind dies: a asymptotisch, g geodätisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Load at a vertex</source>
   <translation>Last je Ecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Load of 1 mm2</source>
   <translation>Last je 1 mm2</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Loads</source>
   <translation>Lasten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>Loads: {}</source>
   <translation>Lasten: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Louvre axis</source>
   <translation>Lamellenachse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>M12</source>
   <translation>M12</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>M16</source>
   <translation>M16</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>M20</source>
   <translation>M20</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>M24</source>
   <translation>M24</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>M27</source>
   <translation>M27</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>M30</source>
   <translation>M30</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Material</source>
   <translation>Material</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Mean curvature</source>
   <translation>Mittlere Krümmung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Measure</source>
   <translation>Maß</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Medial lines</source>
   <translation>Mittellinien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Members</source>
   <translation>Stäbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Members buckle in so many times their length</source>
   <translation>Stäbe knicken auf so viele Male ihre Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Midpoints of the edges: a parallelogram in each face</source>
   <translation>Mittelpunkte der Kanten: ein Parallelogramm in jeder Masche</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Mirror</source>
   <translation>Spiegeln</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Modes</source>
   <translation>Knickformen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Moebius transformation</source>
   <translation>Möbius-Transformation</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it bends lines more evenly on the way; none is usual</source>
   <translation>Mehr davon biegt Linien unterwegs gleichmäßiger; üblich ist keines</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it draws lines straighter on the way; 0.01 is usual</source>
   <translation>Mehr davon zieht Linien unterwegs gerader; üblich ist 0,01</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps direction and length of edges; 0.02 is usual</source>
   <translation>Mehr davon erhält Richtung und Länge der Kanten; üblich ist 0,02</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps pairs of faces orthogonal; 0.001 is usual</source>
   <translation>Mehr davon hält Paare von Flächen rechtwinklig; üblich ist 0,001</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps vertices nearer to where they are; 0.003 is usual</source>
   <translation>Mehr davon hält Ecken näher an ihrem Ort; üblich ist 0,003</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it moves neighbours more alike; 0.1 is usual</source>
   <translation>Mehr davon bewegt Nachbarn ähnlicher; üblich ist 0,1</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Move</source>
   <translation>Verschieben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Move there</source>
   <translation>Dorthin bewegen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Moved, turned and scaled</source>
   <translation>Verschoben, gedreht und skaliert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Moving</source>
   <translation>Bewegt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Multi patch</source>
   <translation>Multinetz-Feld</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Multi-net</source>
   <translation>Multinetz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Multi-net: no, off by {:.1e} over all rectangles of lines</source>
   <translation>Multinetz: nein, um {:.1e} verfehlt über alle Rechtecke aus Parameterlinien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Multi-net: no, the mesh is not of grid type</source>
   <translation>Multinetz: nein, die Vierecke bilden kein Gitter</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Multi-net: yes, to {:.1e} over all rectangles of lines</source>
   <translation>Multinetz: ja, auf {:.1e} über alle Rechtecke aus Parameterlinien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Names and marks</source>
   <translation>Namen und Marken</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Narrowest</source>
   <translation>Engste</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Near</source>
   <translation>Nahe</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Nest on sheets</source>
   <translation>Auf Tafeln schachteln</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Net</source>
   <translation>Netz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Nets joined into one where borders meet, also within one net</source>
   <translation>Netze zu einem verbunden, wo Ränder sich treffen, auch in einem Netz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>New vertices lie in the middle, or all are smoothed</source>
   <translation>Neue Ecken liegen in der Mitte, oder alle werden geglättet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Next buckling shape</source>
   <translation>Nächste Knickform</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Next combination</source>
   <translation>Nächste Kombination</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Next diagram of forces</source>
   <translation>Nächster Schnittgrößenverlauf</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>No boundary beams</source>
   <translation>Keine Randträger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>No recommendation for this mesh.</source>
   <translation>Keine Empfehlung für dieses Netz.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Node</source>
   <translation>Knoten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Node axes</source>
   <translation>Knotenachsen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Normal</source>
   <translation>Normale</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Not now</source>
   <translation>Jetzt nicht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Off by</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Off the surface by {} at most, {} on average.</source>
   <translation>Von der Fläche höchstens {} entfernt, im Mittel {}.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Offset</source>
   <translation>Lage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>One of the two meshes of face diagonals</source>
   <translation>Eines der beiden Netze der Maschendiagonalen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>One turn rises by this</source>
   <translation>Eine Umdrehung steigt um dies</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Optimise</source>
   <translation>Optimieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/again.py" />
   <source>Optimise again</source>
   <translation>Noch einmal optimieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Optimise for: {} (off by {:.1e} on average)</source>
   <translation>Optimieren für: {} (im Mittel um {:.1e} daneben)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Optimise {}</source>
   <translation>{} optimieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/requirements.py" />
   <source>Ortho: these Python packages are missing: {}</source>
   <translation>Ortho: diese Python-Pakete fehlen: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonal multi-net in elliptic coordinates</source>
   <translation>Orthogonales Multinetz in elliptischen Koordinaten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonal multi-net of a polyline drawn on a quadric</source>
   <translation>Orthogonales Multinetz eines auf eine Quadrik gezeichneten Linienzugs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonality</source>
   <translation>Orthogonalität</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonality diagonals</source>
   <translation>Rechtwinkligkeit diag.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Other side up, or families u and v exchanged</source>
   <translation>Andere Seite nach oben, oder Scharen u und v vertauscht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Other than four lines meet here: auto for the fewest that the surface needs, none, or a file of rows x y z and 3, 5 or 6 lines</source>
   <translation>Hier treffen sich andere als vier Linien: auto für die wenigsten, die die Fläche braucht, none für keine, oder eine Datei mit Zeilen x y z und 3, 5 oder 6 Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Outside</source>
   <translation>Außen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Overhang</source>
   <translation>Überstand</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Overlays</source>
   <translation>Überlagerungen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Own shape</source>
   <translation>Eigene Form</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Packages for the Ortho workbench</source>
   <translation>Pakete für den Arbeitsbereich Ortho</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Packing</source>
   <translation>Packung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel edge</source>
   <translation>Plattenkante</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel shear</source>
   <translation>Schub</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel thickness</source>
   <translation>Plattendicke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels</source>
   <translation>Platten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels and lengths of edges may be this far from the shape of their kind</source>
   <translation>Paneele und Kantenlängen dürfen so weit von der Form ihrer Art abweichen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels weigh this much by their surface, kN/m2</source>
   <translation>Paneele wiegen so viel, bezogen auf ihre Fläche, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels with what holds them have this shear stiffness G t, kN/mm; with 0 they are load only</source>
   <translation>Paneele mit dem, was sie hält, haben diese Schubsteifigkeit G t, kN/mm; mit 0 sind sie nur Last</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Paper</source>
   <translation>Papier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parallel edges, each diagonal parallel to the other one; of a sphere a minimal surface</source>
   <translation>Parallele Kanten, jede Diagonale parallel zur anderen; von einer Kugel eine Minimalfläche</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Parameter lines u and v</source>
   <translation>Parameterlinien u und v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Parts are made along lines of these families.</source>
   <translation>Teile entstehen längs der Linien dieser Scharen.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Parts are made along these lines only, numbered such as 0, 3.</source>
   <translation>Teile entstehen nur längs dieser Linien, mit Nummern wie 0, 3.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Parts are nested on sheets.</source>
   <translation>Teile werden auf Tafeln verschachtelt.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts in 3DM</source>
   <translation>Teile in 3DM</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts in IFC</source>
   <translation>Teile in IFC</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pattern</source>
   <translation>Zuschnitt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Periods</source>
   <translation>Perioden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Pick</source>
   <translation>Wählen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/form_panel.py" />
   <source>Pick supports</source>
   <translation>Lager wählen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_picking.py" />
   <source>Pick vertices</source>
   <translation>Ecken wählen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Picture (*.png)</source>
   <translation>Bild (*.png)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Picture written to {}</source>
   <translation>Bild geschrieben nach {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Piece length</source>
   <translation>Stücklänge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pieces</source>
   <translation>Teile</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pitch</source>
   <translation>Ganghöhe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Placement</source>
   <translation>Platzierung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Planar nets: the diagonals of a face are this far apart at most</source>
   <translation>Ebene Netze: Die Diagonalen einer Fläche sind höchstens so weit auseinander</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Planarity</source>
   <translation>Ebenheit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Plane lines</source>
   <translation>Ebene Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Point</source>
   <translation>Punkt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Point loads</source>
   <translation>Einzellasten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Points</source>
   <translation>Punkte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Points where the medial lines of the faces cross</source>
   <translation>Punkte, in denen die Mittellinien der Maschen sich kreuzen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Position</source>
   <translation>Stellung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post diameter</source>
   <translation>Pfostenrohr</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post wall</source>
   <translation>Pfostenwand</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>Press the mouse on the surface and draw a line that the net runs along; Esc leaves it out.</source>
   <translation>Drücken Sie die Maus auf der Fläche und zeichnen Sie eine Linie, an der das Netz entlangläuft; Esc verwirft sie.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Press the mouse on the surface where there is to be one more.</source>
   <translation>Die Maus auf der Fläche drücken, wo noch eine sein soll.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pressure</source>
   <translation>Druck</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Prices</source>
   <translation>Preise</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Profile</source>
   <translation>Profil</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Profile of (radius, height) points turned about z, n points along it by interpolation.</source>
   <translation>Profil aus Punkten (Radius, Höhe), um z gedreht, n Punkte längs durch Interpolation.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>Put back.</source>
   <translation>Zurückgestellt.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Quad mesh</source>
   <translation>Vierecksnetz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Quadric</source>
   <translation>Quadrik</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/sources.py" />
   <source>Quads from triangles</source>
   <translation>Vierecke aus Dreiecken</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Quads that the border cuts are set onto it, or left out</source>
   <translation>Vierecke, die der Rand schneidet, werden auf ihn gesetzt oder weggelassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>R12</source>
   <translation>R12</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>R2010</source>
   <translation>R2010</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Radius</source>
   <translation>Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ratio</source>
   <translation>Verhältnis</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Reach</source>
   <translation>Reichweite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>Recommended: &lt;b&gt;{}&lt;/b&gt;</source>
   <translation>Empfohlen: &lt;b&gt;{}&lt;/b&gt;</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Redraws</source>
   <translation>Bilder</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Reflect</source>
   <translation>Spiegeln</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Reflection lines</source>
   <translation>Reflexionslinien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/sources.py" />
   <source>Remeshing to quads</source>
   <translation>Umbau in Vierecke</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Remove</source>
   <translation>Entfernen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Reset</source>
   <translation>Zurücksetzen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Residuals up to this count as zero</source>
   <translation>Residuen bis hierher zählen als null</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Reverse</source>
   <translation>Umkehren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rhino gets parts, the net, its lines and axes, on layers</source>
   <translation>Rhino bekommt Teile, das Netz, seine Linien und Achsen, auf Layern</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rings</source>
   <translation>Ringe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rings or rows of faces cut off</source>
   <translation>Ringe oder Reihen von Maschen abgeschnitten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rise</source>
   <translation>Stich</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rounded</source>
   <translation>Gerundet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rows</source>
   <translation>Reihen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rule</source>
   <translation>Regel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Rulings of strips</source>
   <translation>Erzeugende der Streifen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Running ...</source>
   <translation>Läuft ...</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>S235</source>
   <translation>S235</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>S275</source>
   <translation>S275</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>S355</source>
   <translation>S355</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>STEP files</source>
   <translation>STEP-Dateien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sampling</source>
   <translation>Abtastung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Save picture</source>
   <translation>Bild speichern</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Saw</source>
   <translation>Sägeschnitt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Saw cut</source>
   <translation>Sägeschnitt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Saw list</source>
   <translation>Sägeliste</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Scale</source>
   <translation>Maßstab</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Scherk's surface z = ln(cos y / cos x).</source>
   <translation>Scherksche Fläche z = ln(cos y / cos x).</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Second</source>
   <translation>Zweiter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Second formula</source>
   <translation>Zweite Formel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Second order</source>
   <translation>Zweite Ordnung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section</source>
   <translation>Querschnitt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Section and material are those of these beams or lamellas.</source>
   <translation>Querschnitt und Werkstoff sind die dieser Träger oder Lamellen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section width</source>
   <translation>Breite des Querschnitts</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sections stand as those of beams do, or as lamellas of plate:THICKNESSxWIDTH: standing, lying or tilted as the net wants it</source>
   <translation>Querschnitte stehen wie die von Trägern oder als Lamellen plate:DICKExBREITE: stehend, liegend oder geneigt, wie das Netz es verlangt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Seed</source>
   <translation>Startwert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Self weight</source>
   <translation>Eigengewicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Semi axes</source>
   <translation>Halbachsen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Settings of the net</source>
   <translation>Einstellungen des Netzes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet</source>
   <translation>Tafel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Sheet height</source>
   <translation>Tafelhöhe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet of the tangents of a spine, by rulings (v) and involutes (u).</source>
   <translation>Blech aus den Tangenten einer Leitkurve, durch Erzeugende (v) und Evolventen (u).</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet sizes</source>
   <translation>Plattengrößen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Sheet width</source>
   <translation>Tafelbreite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>Sheet {}</source>
   <translation>Tafel {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Show the field</source>
   <translation>Richtungsfeld zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Show the net</source>
   <translation>Netz einblenden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Show the scale</source>
   <translation>Die Skala zeigen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Singular vertices</source>
   <translation>Singuläre Ecken</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Singularities</source>
   <translation>Singularitäten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Site origin</source>
   <translation>Ursprung auf dem Bau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Site rotation</source>
   <translation>Drehung auf dem Bau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Size</source>
   <translation>Größe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slivers</source>
   <translation>Splitter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slots</source>
   <translation>Schlitze</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slots leave this part of the height of lamellas that cross in one layer; with 1 there are none</source>
   <translation>Schlitze lassen diesen Teil der Höhe von Lamellen, die sich in einer Lage kreuzen; mit 1 gibt es keine</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Smooth</source>
   <translation>Glatt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Smooth motion</source>
   <translation>Glatte Bewegung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow</source>
   <translation>Schnee</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow also lies on one half, as a case of its own: the half towards this direction</source>
   <translation>Schnee liegt als eigener Fall auch auf einer Hälfte: der in dieser Richtung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow side</source>
   <translation>Schneeseite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow weighs this much by the plan, kN/m2</source>
   <translation>Schnee wiegt so viel, bezogen auf den Grundriss, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many modes of buckling are found</source>
   <translation>So viele Knickformen werden gesucht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>So many processes share the work.</source>
   <translation>So viele Prozesse teilen sich die Arbeit.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rings of faces are cut off at the border</source>
   <translation>So viele Ringe von Flächen werden am Rand abgeschnitten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rows are cut off at the starts and ends of u and v</source>
   <translation>So viele Reihen werden an Anfang und Ende von u und v abgeschnitten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many times four faces are made of one</source>
   <translation>So oft werden aus einer Fläche vier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many vertices stand along u and along v</source>
   <translation>So viele Ecken stehen längs u und längs v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Socket depth</source>
   <translation>Hülsentiefe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spacing</source>
   <translation>Teilung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sphere by meridians and parallels; planar, circular, equal diagonals, vertices on the sphere.</source>
   <translation>Kugel durch Meridiane und Breitenkreise; eben, zirkular, gleiche Diagonalen, Ecken auf der Kugel.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Spheres of vertex stars</source>
   <translation>Kugeln der Eckensterne</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spherical stars</source>
   <translation>Sphärische Sterne</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spherical stars diagonals</source>
   <translation>Sphärische Sterne, Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spine</source>
   <translation>Leitkurve</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Splice every</source>
   <translation>Stoß alle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stands on</source>
   <translation>Steht auf</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Start</source>
   <translation>Start</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>State</source>
   <translation>Zustand</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Stays</source>
   <translation>Bleibt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Step</source>
   <translation>Schritt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Step {} of {}: {}</source>
   <translation>Schritt {} von {}: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stock</source>
   <translation>Lagerlänge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structures.py" />
   <source>Stock length</source>
   <translation>Lagerlänge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stock lengths</source>
   <translation>Lagerlängen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Stop</source>
   <translation>Stopp</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Stopped. A change or OK begins again.</source>
   <translation>Angehalten. Eine Änderung oder OK beginnt von neuem.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Stopped. Nothing was installed.</source>
   <translation>Angehalten. Nichts wurde installiert.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Stopped. OK keeps this state, Start goes on.</source>
   <translation>Angehalten. OK behält diesen Stand, Start fährt fort.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Straight upright lamellas that all cross at one angle.</source>
   <translation>Gerade, stehende Lamellen, die sich alle unter einem Winkel kreuzen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strength</source>
   <translation>Stärke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress</source>
   <translation>Spannung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a millimetre of edge has this weight</source>
   <translation>Spannungsnetze: Ein Millimeter Kante hat dieses Gewicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a square millimetre carries this load, downwards</source>
   <translation>Spannungsnetze: Ein Quadratmillimeter trägt diese Last, nach unten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: edges may carry these forces</source>
   <translation>Spannungsnetze: Kanten dürfen diese Kräfte tragen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: every vertex carries this load, downwards</source>
   <translation>Spannungsnetze: Jede Ecke trägt diese Last, nach unten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: the shell whose stresses the lines follow stands on this</source>
   <translation>Spannungsnetze: Die Schale, deren Spannungen die Linien folgen, steht hierauf</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: this carries the loads: boundary, which slides along its own curve but for its corners; corners or vertices such as 0,5,12, which stay; empty: as the net needs</source>
   <translation>Spannungsnetze: Dies trägt die Lasten: boundary für den Rand, der bis auf seine Ecken längs seiner eigenen Kurve gleitet; corners oder Ecken wie 0,5,12, die bleiben; leer: wie das Netz es braucht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strip</source>
   <translation>Streifen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along u</source>
   <translation>Streifen entlang u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along u have this angle to the surface: 90 stands, 180 lies</source>
   <translation>Streifen längs u haben diesen Winkel zur Fläche: 90 steht, 180 liegt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along v</source>
   <translation>Streifen entlang v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along v have this angle to the surface: 90 stands, 180 lies</source>
   <translation>Streifen längs v haben diesen Winkel zur Fläche: 90 steht, 180 liegt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Strokes</source>
   <translation>Leitkurven</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structural_checks.py" />
   <source>Structural check</source>
   <translation>Statische Prüfung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Structures</source>
   <translation>Tragwerke</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Supports</source>
   <translation>Lager</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Swap</source>
   <translation>Tauschen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Symmetry</source>
   <translation>Symmetrie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>T</source>
   <translation>T</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>T range</source>
   <translation>Bereich von t</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>That is more than the {} allowed.</source>
   <translation>Das sind mehr als die erlaubten {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>That is more than the {} that were allowed, at face {}.</source>
   <translation>Das ist mehr als die erlaubten {}, an Fläche {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>The Ortho workbench needs Python packages that FreeCAD does not find: {names}.

Install downloads them with what they need, up to 2 GB on disk, into FreeCAD's own folder for add-ons:
{folder}
Nothing else on this computer is changed.</source>
   <translation>Der Arbeitsbereich Ortho braucht Python-Pakete, die FreeCAD nicht findet: {names}.

Installieren lädt sie und was sie brauchen, bis zu 2 GB auf der Platte, in FreeCADs eigenen Ordner für Erweiterungen:
{folder}
Sonst wird auf diesem Rechner nichts verändert.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>The Python package {} is not installed.</source>
   <translation>Das Python-Paket {} ist nicht installiert.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along x rises by this, or hangs where it is negative</source>
   <translation>Der Bogen längs x steigt um dies, oder hängt, wo es negativ ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along y rises by this, or hangs where it is negative</source>
   <translation>Der Bogen längs y steigt um dies, oder hängt, wo es negativ ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The border is left a zigzag, or closed by narrow quads</source>
   <translation>Der Rand bleibt ein Zickzack oder wird mit schmalen Vierecken geschlossen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The cables have this force density, force / length</source>
   <translation>Die Seile haben diese Kraftdichte, Kraft / Länge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The chosen vertex goes to this place.</source>
   <translation>Die gewählte Ecke kommt an diesen Ort.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The chosen vertices are no handles any more.</source>
   <translation>Die gewählten Ecken sind keine Griffe mehr.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The curve goes through these points instead, about the centre</source>
   <translation>Die Kurve geht stattdessen durch diese Punkte, um die Mitte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The edges carry this load, force / mm</source>
   <translation>Die Kanten tragen diese Last, Kraft / mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The ends of a curve that is no preset are joined</source>
   <translation>Die Enden einer Kurve, die keine Vorgabe ist, werden verbunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this load, force / mm2</source>
   <translation>Die Flächen tragen diese Last, Kraft / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this pressure along their normals, force / mm2</source>
   <translation>Die Flächen tragen diesen Druck längs ihrer Normalen, Kraft / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The families u and v change places</source>
   <translation>Die Scharen u und v tauschen ihre Plätze</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of the two holds the first vertex</source>
   <translation>Das erste der beiden enthält die erste Ecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of them follows this formula of s</source>
   <translation>Die erste davon folgt dieser Formel von s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix has this radius</source>
   <translation>Die Schraubenlinie hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix turns by this angle</source>
   <translation>Die Schraubenlinie dreht sich um diesen Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The imperfection is this large</source>
   <translation>Die Imperfektion ist so groß</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The inversion has its centre here</source>
   <translation>Die Inversion hat hier ihr Zentrum</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The largest displacement that passes is this part of the second longest side of the net's box: 200 for 1/200</source>
   <translation>Die größte Verschiebung, die besteht, ist dieser Teil der zweitlängsten Seite der Box des Netzes: 200 für 1/200</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The largest gap of a face is {}, of face {}.</source>
   <translation>Der größte Spalt einer Fläche ist {}, an Fläche {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The largest miss is {}.</source>
   <translation>Die größte Abweichung ist {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/residual_plot.py" />
   <source>The largest residuals by steps. Below the dashed line they count as zero.</source>
   <translation>Die größten Residuen nach Schritten. Unter der gestrichelten Linie gelten sie als null.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The last point is joined with the first</source>
   <translation>Der letzte Punkt wird mit dem ersten verbunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The lower end has this radius</source>
   <translation>Das untere Ende hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members are made of this</source>
   <translation>Die Stäbe sind hieraus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members have this profile; groups another one after it, as tube:100x60x5,border=tube:120x60x5</source>
   <translation>Die Stäbe haben dieses Profil; Gruppen dahinter ein anderes, wie tube:100x60x5,border=tube:120x60x5</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane has this stress, force / length</source>
   <translation>Die Membran hat diese Spannung, Kraft / Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane's border cable has this force</source>
   <translation>Das Randseil der Membran hat diese Kraft</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>The mesh is {:.1e} from it on average</source>
   <translation>Das Netz ist im Mittel {:.1e} davon entfernt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The middle of sections lies this far above the net, along its axes</source>
   <translation>Die Mitte der Querschnitte liegt so weit über dem Netz, längs seiner Achsen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror image comes alone</source>
   <translation>Das Spiegelbild kommt allein</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane goes through this point</source>
   <translation>Die Spiegelebene geht durch diesen Punkt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane has this normal</source>
   <translation>Die Spiegelebene hat diese Normale</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The mouse draws handles this way.</source>
   <translation>Die Maus zieht Griffe auf diese Weise.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The multi-net guide keeps patches of so many faces along and across orthogonal</source>
   <translation>Die Multinetz-Führung hält Stücke von so vielen Flächen längs und quer orthogonal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The narrowest circle has this radius</source>
   <translation>Der engste Kreis hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net and its mirror image, the seam merged</source>
   <translation>Das Netz und sein Spiegelbild, die Naht verschmolzen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of u</source>
   <translation>Das Netz bedeckt diesen Teil des Bereichs von u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of v</source>
   <translation>Das Netz bedeckt diesen Teil des Bereichs von v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>The net follows in a moment.</source>
   <translation>Das Netz folgt gleich.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net follows these lines of the surface</source>
   <translation>Das Netz folgt diesen Linien der Fläche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these angles about the axis</source>
   <translation>Das Netz geht vom ersten zum zweiten dieser Winkel um die Achse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these latitudes</source>
   <translation>Das Netz geht vom ersten zum zweiten dieser Breitengrade</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t of the confocal family</source>
   <translation>Das Netz geht vom ersten zum zweiten t der konfokalen Schar</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t; with 0 and 0 it keeps clear of both ends</source>
   <translation>Das Netz geht vom ersten zum zweiten t; mit 0 und 0 hält es Abstand von beiden Enden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes on along these axes as its mirror image, as x,y</source>
   <translation>Das Netz geht längs dieser Achsen als sein Spiegelbild weiter, wie x,y</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The net has changed meanwhile. Start begins anew.</source>
   <translation>Das Netz hat sich inzwischen geändert. Start beginnt von vorn.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The net is as it was before.</source>
   <translation>Das Netz ist wie vorher.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>The net is hidden: nothing of this is seen.</source>
   <translation>Das Netz ist ausgeblendet: davon ist nichts zu sehen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is its own mirror image in these planes: auto for those that the surface has, or those across an axis, through the middle of the surface</source>
   <translation>Das Netz ist sein eigenes Spiegelbild in diesen Ebenen: auto für die der Fläche, oder die quer zu einer Achse, durch die Mitte der Fläche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is made of cables, or is a membrane of one stress</source>
   <translation>Das Netz ist aus Seilen oder eine Membran gleicher Spannung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is moved by this</source>
   <translation>Das Netz wird um dies verschoben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is scaled by this factor</source>
   <translation>Das Netz wird mit diesem Faktor skaliert</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>The net is this already: {}</source>
   <translation>Das Netz ist dies schon: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this long along x</source>
   <translation>Das Netz ist längs x so lang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this wide across</source>
   <translation>Das Netz ist quer so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is to become this one; asymptotic and cmc lines run at 45 degrees to curvature, those of asymptotic-angle where the surface does not bend, stress lines as a shell carries its weight</source>
   <translation>Das Netz soll dieses werden; asymptotische und cmc-Linien laufen 45 Grad zur Krümmung, die von asymptotic-angle in Richtungen, in denen sich die Fläche nicht krümmt, Spannungslinien so, wie eine Schale ihr Gewicht trägt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is turned by these angles about x, then y, then z</source>
   <translation>Das Netz wird um diese Winkel um x, dann y, dann z gedreht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>The net keeps being its own mirror image in the plane through 0.</source>
   <translation>Das Netz bleibt sein eigenes Spiegelbild in der Ebene durch 0.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches so far over the surface, farther where this is larger</source>
   <translation>Das Netz reicht so weit über die Fläche, weiter, wo dies größer ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches this far from the axis on both sides</source>
   <translation>Das Netz reicht auf beiden Seiten so weit von der Achse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net runs along these lines, drawn on the surface</source>
   <translation>Das Netz läuft längs dieser auf die Fläche gezeichneten Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net stands here, turned like this</source>
   <translation>Das Netz steht hier, so gedreht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>The net was changed.</source>
   <translation>Das Netz wurde geändert.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The offset lies this far along the normals, below where it is negative</source>
   <translation>Der Versatz liegt so weit längs der Normalen, darunter, wo es negativ ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The other side is turned up</source>
   <translation>Die andere Seite wird nach oben gedreht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>The packages could not be installed:</source>
   <translation>Die Pakete konnten nicht installiert werden:</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>The parts lie on these beams.</source>
   <translation>Die Teile liegen auf diesen Trägern.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline goes through these points, in the frame of the quadric</source>
   <translation>Der Streckenzug geht durch diese Punkte, im System der Quadrik</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline lies on this quadric</source>
   <translation>Der Streckenzug liegt auf dieser Quadrik</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>The range goes by powers of ten, such as -6.</source>
   <translation>Der Bereich geht nach Zehnerpotenzen, etwa -6.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The result may be this far off the surface, or the start where none is given</source>
   <translation>Das Ergebnis darf so weit von der Fläche entfernt sein, oder vom Start, wo keine angegeben ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The second of them follows this formula of s</source>
   <translation>Die zweite davon folgt dieser Formel von s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes are this long, the largest comes first</source>
   <translation>Die Halbachsen sind so lang, die größte kommt zuerst</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of lambda = 0 are this long, the largest comes first</source>
   <translation>Die Halbachsen von lambda = 0 sind so lang, die größte kommt zuerst</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of the quadric are this long</source>
   <translation>Die Halbachsen der Quadrik sind so lang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The shape moved by up to {} ({:.1f} mean edges). Its size was {} and is {}.</source>
   <translation>Die Form hat sich um bis zu {} bewegt ({:.1f} mittlere Kanten). Ihre Größe war {} und ist {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>The sheets are this high.</source>
   <translation>Die Tafeln sind so hoch.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>The sheets are this wide.</source>
   <translation>Die Tafeln sind so breit.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The source of this net has changed since; it stays as it is.</source>
   <translation>Die Quelle dieses Netzes hat sich seither geändert; es bleibt, wie es ist.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The source of this net has changed. Start begins anew with what it makes now.</source>
   <translation>Die Quelle dieses Netzes hat sich geändert. Start beginnt neu mit dem, was sie jetzt macht.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has its centre here</source>
   <translation>Die Kugel hat hier ihre Mitte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has this radius</source>
   <translation>Die Kugel hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface grows in proportion to this length</source>
   <translation>Die Fläche wächst im Verhältnis zu dieser Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has so many waves along its axis</source>
   <translation>Die Fläche hat längs ihrer Achse so viele Wellen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has this radius</source>
   <translation>Die Fläche hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface is this high</source>
   <translation>Die Fläche ist so hoch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The tangents of these points make the sheet; empty for a helix</source>
   <translation>Die Tangenten an diesen Punkten bilden die Fläche; leer für eine Schraubenlinie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two directions meet at this angle</source>
   <translation>Die beiden Richtungen treffen sich in diesem Winkel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>The two directions that lines follow; grey where curvature does not say much.</source>
   <translation>Die beiden Richtungen, denen Linien folgen; grau, wo die Krümmung wenig aussagt.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates follow this curve</source>
   <translation>Die beiden anderen Koordinaten folgen dieser Kurve</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates have these values instead</source>
   <translation>Die beiden anderen Koordinaten haben stattdessen diese Werte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The upper end has this radius</source>
   <translation>Das obere Ende hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The weight of the members is a load</source>
   <translation>Das Gewicht der Stäbe ist eine Last</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>The weight of this structure is a load by the surface.</source>
   <translation>Das Gewicht dieses Tragwerks ist eine Last auf die Fläche.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The widest circle has this radius</source>
   <translation>Der weiteste Kreis hat diesen Radius</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>The wind has this pressure in kN/m2 and blows this way: 0.6@x; 0.6@-y.</source>
   <translation>Der Wind hat diesen Druck in kN/m2 und weht dorthin: 0.6@x; 0.6@-y.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>There may be so many kinds; 0 is as few as can be found</source>
   <translation>So viele Arten darf es geben; 0 heißt so wenige wie möglich</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or numbers of vertices, each with :pinned, :fixed, :sliding (up and down only) or :springs=X/Y/Z (kN/mm), joined by +</source>
   <translation>Dies wird gehalten: boundary, corners oder Nummern von Ecken, jeweils mit :pinned, :fixed, :sliding (nur auf und ab) oder :springs=X/Y/Z (kN/mm), mit + verbunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or vertices as 0,5,12</source>
   <translation>Dies wird gehalten: boundary, corners oder Ecken wie 0,5,12</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These lines lie in planes of their own</source>
   <translation>Diese Linien liegen in eigenen Ebenen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These points (radius, height) are turned about z</source>
   <translation>Diese Punkte (Radius, Höhe) werden um z gedreht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These supports are raised first, VERTEX:HEIGHT in mm as 0:1500; 20:900</source>
   <translation>Diese Auflager werden zuerst angehoben, ECKE:HÖHE in mm wie 0:1500; 20:900</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>These vertices carry these forces in kN: 12:0,0,-5; 13:0,0,-5.</source>
   <translation>Diese Ecken tragen diese Kräfte in kN: 12:0,0,-5; 13:0,0,-5.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>These vertices do not move; numbers such as 0,5,12 work too.</source>
   <translation>Diese Ecken bewegen sich nicht; auch Nummern wie 0,5,12 gehen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Thickness</source>
   <translation>Dicke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This elliptic coordinate has the role of t</source>
   <translation>Diese elliptische Koordinate hat die Rolle von t</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This part of the range is left free at each end</source>
   <translation>Dieser Teil des Bereichs bleibt an jedem Ende frei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This point stays where it is</source>
   <translation>Dieser Punkt bleibt, wo er ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>This quantity colours the net.</source>
   <translation>Diese Größe färbt das Netz.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Three families of straight slats, which brace each other.</source>
   <translation>Drei Scharen gerader Latten, die einander aussteifen.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Through</source>
   <translation>Durchlaufend</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tilt</source>
   <translation>Neigung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tilted lamellas that unroll straight, one angle a family.</source>
   <translation>Geneigte Lamellen, die sich gerade abwickeln, ein Winkel je Schar.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Time limit (s)</source>
   <translation>Zeitgrenze (s)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>To</source>
   <translation>Bis</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tolerance</source>
   <translation>Toleranz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Top radius</source>
   <translation>Oberer Radius</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Triangle mesh</source>
   <translation>Dreiecksnetz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/remesh_panel.py" />
   <source>Triangles</source>
   <translation>Dreiecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Trim</source>
   <translation>Anschnitt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Trimmed ends</source>
   <translation>Anschnitt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Turn</source>
   <translation>Drehen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Twist</source>
   <translation>Verwindung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>U part</source>
   <translation>Teil von u</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Undo</source>
   <translation>Rückgängig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Unduloid (Delaunay), mean curvature 1 / (widest + narrowest) as the mean of both principals.</source>
   <translation>Unduloid (Delaunay), mittlere Krümmung 1 / (weiteste + engste) als Mittel beider Hauptkrümmungen.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structures.py" />
   <source>Update structures</source>
   <translation>Tragwerke aktualisieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>Use</source>
   <translation>Nehmen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Utilisation</source>
   <translation>Ausnutzung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>V part</source>
   <translation>Teil von v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Vertex</source>
   <translation>Ecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertex load</source>
   <translation>Eckenlast</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>Vertex {} is fixed.</source>
   <translation>Ecke {} ist fest.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices that are nearer than this are merged</source>
   <translation>Ecken, die näher als dies sind, werden vereinigt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices, edges or faces keep the distance, or edges stay parallel</source>
   <translation>Ecken, Kanten oder Flächen halten den Abstand, oder Kanten bleiben parallel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Waist</source>
   <translation>Taille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Web</source>
   <translation>Gewebe</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Weight of</source>
   <translation>Gewicht von</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Weight of 1 mm edge</source>
   <translation>Gewicht je 1 mm Kante</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Where lines u and v cross, in slots of one layer or about the bolts of two, they turn like this about their axis: rigid, hinged, or the stiffness of a spring in kNm/rad</source>
   <translation>Wo Linien u und v sich kreuzen, in Schlitzen einer Lage oder um die Schrauben von zweien, drehen sie sich so um ihre Achse: rigid, hinged oder die Steifigkeit einer Feder in kNm/rad</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Which</source>
   <translation>Welches</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Widest</source>
   <translation>Weiteste</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Width</source>
   <translation>Breite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Width x height in pixels</source>
   <translation>Breite x Höhe in Pixeln</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Wind</source>
   <translation>Wind</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Within</source>
   <translation>Innerhalb</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Workers</source>
   <translation>Prozesse</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Worst</source>
   <translation>Max.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Write files</source>
   <translation>Dateien schreiben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structures.py" />
   <source>Writing fabrication files</source>
   <translation>Fertigungsdateien schreiben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structural_checks.py" />
   <source>Writing files of the check</source>
   <translation>Dateien der Prüfung werden geschrieben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a block for each part</source>
   <translation>ein Block je Teil</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a file for each part</source>
   <translation>eine Datei je Teil</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a joint has so many bolts above each other</source>
   <translation>so viele Schrauben hat ein Anschluss übereinander</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a length for each direction</source>
   <translation>eine Länge je Richtung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a patch is built up to this distortion of an edge</source>
   <translation>ein Flächenstück wird bis zu dieser Verzerrung einer Kante gebaut</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a saw cut behind a piece is this wide</source>
   <translation>ein Sägeschnitt hinter einem Stück ist so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a third layer lies along these diagonals, which brace the net</source>
   <translation>eine dritte Lage liegt auf diesen Diagonalen, die das Netz aussteifen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a0</source>
   <translation>A0</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a1</source>
   <translation>A1</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a2</source>
   <translation>A2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a3</source>
   <translation>A3</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a4</source>
   <translation>A4</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>above</source>
   <translation>darüber</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>all</source>
   <translation>alle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along</source>
   <translation>längs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along X (X)</source>
   <translation>längs X (X)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along Y (Y)</source>
   <translation>längs Y (Y)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along Z (Z)</source>
   <translation>längs Z (Z)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along curvature</source>
   <translation>entlang der Krümmung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along the normal (N)</source>
   <translation>längs der Normalen (N)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along the sheet</source>
   <translation>längs der Tafel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along u</source>
   <translation>entlang u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along v</source>
   <translation>entlang v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>aluminium</source>
   <translation>Aluminium</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>angles with bolts join strips where these end</source>
   <translation>Winkel mit Schrauben verbinden Streifen an ihren Enden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>another number begins another search for a dense nesting</source>
   <translation>eine andere Zahl beginnt eine andere Suche nach dichter Schachtelung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>another number gives another layout of quads</source>
   <translation>eine andere Zahl gibt eine andere Anordnung der Vierecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>arc</source>
   <translation>Bogen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>arch</source>
   <translation>Bogen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as few as can be found</source>
   <translation>so wenige wie möglich</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as it starts</source>
   <translation>wie es beginnt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as long as it takes</source>
   <translation>so lang wie nötig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as single strokes</source>
   <translation>als Einzelstriche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as solids too</source>
   <translation>auch als Körper</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as text</source>
   <translation>als Text</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as the net has it</source>
   <translation>wie das Netz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as thick as the bolts</source>
   <translation>so dick wie die Schrauben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asked too</source>
   <translation>mitverlangt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>assemblies in IFC hold the parts of a system, of a line or of a ring</source>
   <translation>Baugruppen in IFC enthalten die Teile eines Systems, einer Linie oder eines Rings</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic</source>
   <translation>asymptotisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic-angle</source>
   <translation>asymptotic-angle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic: minimal</source>
   <translation>asymptotisch: minimal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic: one angle</source>
   <translation>asymptotisch: ein Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>auto</source>
   <translation>automatisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/fields.py" />
   <source>automatic</source>
   <translation>automatisch</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>automatic: {}</source>
   <translation>automatisch: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>ball</source>
   <translation>Kugel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars and strips are this long; longer lamellas are spliced</source>
   <translation>Stäbe und Streifen sind so lang; längere Lamellen werden gestoßen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars are listed with lengths and angles of both ends, and how to read them</source>
   <translation>Stangen werden aufgelistet, mit Längen und Winkeln beider Enden und wie man sie liest</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars come in these lengths too, mm; the shortest that will do is taken</source>
   <translation>Stäbe gibt es auch in diesen Längen, mm; genommen wird die kürzeste, die reicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars lose this much at each end</source>
   <translation>so viel verlieren Stäbe an jedem Ende</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>base plates and caps are this thick</source>
   <translation>so dick sind Fuß- und Kopfplatten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>beams</source>
   <translation>Träger</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>beams are bolted with bolts of this size</source>
   <translation>die Träger werden mit Schrauben dieser Größe angeschlossen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>beams that are shorter than this at the border are left out</source>
   <translation>Träger, die am Rand kürzer sind, werden weggelassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>below</source>
   <translation>darunter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bent sides in IFC are facets, or exact for programs that read those</source>
   <translation>gebogene Seiten in IFC sind Facetten, oder genau für Programme, die das lesen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bevel</source>
   <translation>abgeschrägt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bolted</source>
   <translation>geschraubt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bolted hubs have walls of this thickness</source>
   <translation>geschraubte Naben haben Wände dieser Dicke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bolts, gaskets and setting blocks are listed, or drawn as solids too</source>
   <translation>Schrauben, Dichtungen und Klötze stehen in der Liste oder sind auch als Körper gezeichnet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>border vertices that turn by more than this are kept</source>
   <translation>Randpunkte, die um mehr als dies abknicken, bleiben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>border, u and v have their own</source>
   <translation>Rand, u und v haben eigene</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>both</source>
   <translation>beide</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>both families</source>
   <translation>beide Scharen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>boundary</source>
   <translation>Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>boxes pack fast, outlines densely</source>
   <translation>Rahmen packen schnell, Umrisse dicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by boxes (fast)</source>
   <translation>Rechtecke (schnell)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by line</source>
   <translation>nach Linie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by outlines (dense)</source>
   <translation>nach Umrissen (dicht)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by ring</source>
   <translation>nach Ring</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by system</source>
   <translation>nach System</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by the sampling</source>
   <translation>nach der Abtastung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cables</source>
   <translation>Seile</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>catenoid</source>
   <translation>Katenoid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>catmull-clark</source>
   <translation>Catmull-Clark</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>centre</source>
   <translation>mittig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>chebyshev</source>
   <translation>Tschebyschow</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>checkerboard</source>
   <translation>Schachbrett</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>circular</source>
   <translation>zirkular</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cmc</source>
   <translation>CMC</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>coarsen</source>
   <translation>vergröbern</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cold</source>
   <translation>kalt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>compression and tension</source>
   <translation>Druck und Zug</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>compression only</source>
   <translation>nur Druck</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cone</source>
   <translation>Kegel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>confocal-conics</source>
   <translation>konfokale Kegelschnitte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>conical</source>
   <translation>konisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>constant mean curvature</source>
   <translation>konst. mittlere Krümmung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>coped-u</source>
   <translation>an u ausgeklinkt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>coped-v</source>
   <translation>an v ausgeklinkt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>corners</source>
   <translation>Eckpunkte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cover-plate</source>
   <translation>Lasche</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>creases between {} faces run at {:.0f} degrees to the lines of curvature on average: lines run along all creases and along the border, where the net ends, in place of curvature. A net along curvature, which has flat panels, is one on each face alone (--faces)</source>
   <translation>Kanten zwischen {} Flächen laufen im Mittel unter {:.0f} Grad zu den Krümmungslinien: Linien laufen entlang aller Kanten und entlang des Randes, an dem das Netz endet, statt entlang der Krümmung. Ein Netz entlang der Krümmung, das ebene Platten hat, gibt es auf jeder Fläche allein (--faces)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>curvature</source>
   <translation>Krümmung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cut</source>
   <translation>abschneiden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cylinder</source>
   <translation>Zylinder</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>developable</source>
   <translation>abwickelbar</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>diagonal mesh</source>
   <translation>Diagonalnetz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>directions</source>
   <translation>Richtungen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>dog</source>
   <translation>diskret orthogonal geodätisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drawings are of this size</source>
   <translation>Zeichnungen haben diese Größe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drawings are of this version</source>
   <translation>Zeichnungen sind von dieser Version</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drawings have this date in their title block</source>
   <translation>Zeichnungen haben dieses Datum im Schriftfeld</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drop</source>
   <translation>weglassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>each part has a file for machines that saw, drill and cut steel (DSTV)</source>
   <translation>jedes Teil hat eine Datei für Maschinen, die Stahl sägen, bohren und schneiden (DSTV)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>each part has a label with a QR code of its name</source>
   <translation>jedes Teil hat ein Etikett mit einem QR-Code seines Namens</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>edge</source>
   <translation>Kante</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>edges</source>
   <translation>Kanten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>edges of metal panels are folded down by this</source>
   <translation>Ränder von Blechplatten werden um dieses Maß abgekantet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>ellipsoid</source>
   <translation>Ellipsoid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>elliptic multi-net</source>
   <translation>elliptisches Multinetz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>elliptic-paraboloid</source>
   <translation>elliptisches Paraboloid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>end-plate</source>
   <translation>Kopfplatte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>enneper</source>
   <translation>Enneper</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>exact</source>
   <translation>genau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>exactly flat</source>
   <translation>genau eben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>face</source>
   <translation>Masche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>faces</source>
   <translation>Flächen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>faces flat to {}</source>
   <translation>Maschen eben auf {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>faces of this size leave the surface by {} between their corners: take a finer mesh, or allow as much</source>
   <translation>Flächen dieser Größe weichen zwischen ihren Ecken um {} von der Fläche ab: nehmen Sie ein feineres Netz, oder lassen Sie so viel zu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>facets</source>
   <translation>Facetten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>factor {:.2f}</source>
   <translation>Faktor {:.2f}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>fill</source>
   <translation>füllen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>first</source>
   <translation>erstes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>folds have this radius inside, by default that of the thickness</source>
   <translation>Kantungen haben innen diesen Radius, sonst den der Dicke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>folds keep the length of the fibre at this part of the thickness, 0: by DIN 6935</source>
   <translation>Kantungen behalten die Länge der Faser bei diesem Teil der Dicke; 0: nach DIN 6935</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>follow</source>
   <translation>folgen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>for about 600 faces</source>
   <translation>für etwa 600 Flächen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>form-finding</source>
   <translation>Formfindung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>formulas</source>
   <translation>Formeln</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>four anchor bolts hold a base plate</source>
   <translation>vier Anker halten eine Fußplatte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>free</source>
   <translation>frei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>gaskets below and above framed panels are this thick</source>
   <translation>so dick sind die Dichtungen unter und über gerahmten Platten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic</source>
   <translation>geodätisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic and Chebyshev</source>
   <translation>geodät. + Tschebyschow</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic, four equal angles</source>
   <translation>geodätisch, gleiche Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic-chebyshev</source>
   <translation>geodätisch und Tschebyschow</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic: developable</source>
   <translation>geodätisch: abwickelbar</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>gfrp</source>
   <translation>GFK</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>given here</source>
   <translation>hier angegeben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>given: {}</source>
   <translation>vorgegeben: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>glTF holds all parts, with names and colours, for viewers</source>
   <translation>glTF enthält alle Teile, mit Namen und Farben, für Betrachter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>glass</source>
   <translation>Glas</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>glide on {}</source>
   <translation>auf {} gleiten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>helicoid</source>
   <translation>Helikoid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>hollow</source>
   <translation>hohl</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>hollow sections and flanges are this wide</source>
   <translation>Hohlprofile und Flansche sind so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>hub</source>
   <translation>Nabe</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/forming.py" />
   <source>in equilibrium, unbalanced {:.0e}; largest support force {:.3g}</source>
   <translation>im Gleichgewicht, unausgeglichen {:.0e}; größte Auflagerkraft {:.3g}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>in the list only</source>
   <translation>nur in der Liste</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>insulating-glass-4-12-4-12-4</source>
   <translation>Isoglas 4/12/4/12/4</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>insulating-glass-6-16-6</source>
   <translation>Isoglas 6/16/6</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>inversion</source>
   <translation>Inversion</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/aligning.py" />
   <source>irregular: {}</source>
   <translation>irregulär: {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isogonal</source>
   <translation>isogonal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isogonal: one angle</source>
   <translation>isogonal: ein Winkel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isometric</source>
   <translation>isometrisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isometric: faces keep shape</source>
   <translation>isometrisch: formtreu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isothermic</source>
   <translation>isotherm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isothermic: has a dual</source>
   <translation>isotherm: hat ein Dual</translation>
  </message>
  <message>
   <location filename="../../../solver/align/guides.py" />
   <source>it is made of flat faces that meet at creases: lines along these cannot run along all eaves as well; a net on each face alone (--faces) keeps to its longest side</source>
   <translation>sie besteht aus ebenen Flächen, die an Knicken aneinanderstoßen: Linien entlang dieser können nicht auch entlang aller Traufen laufen; ein Netz auf jeder Fläche allein (--faces) hält sich an deren längste Seite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>its own boundary</source>
   <translation>sein eigener Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>join</source>
   <translation>anschließen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>joints of structural silicone are this wide</source>
   <translation>so breit sind Fugen aus tragendem Silikon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>labels are printed on this sheet: columns x rows, a4 or letter-3x10</source>
   <translation>Etiketten werden auf diesen Bogen gedruckt: Spalten x Reihen, A4 oder letter-3x10</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lambda</source>
   <translation>lambda</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lapped</source>
   <translation>verblattet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>leave-out</source>
   <translation>weglassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>left out</source>
   <translation>ausgelassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lift</source>
   <translation>anheben</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>lines bunch near ({}): one edge in {} is shorter than {:.0f} % of what was wanted; try: singular vertices beside that place, or another net</source>
   <translation>Linien drängen sich bei ({}): eine von {} Kanten ist kürzer als {:.0f} % des Gewünschten; zu versuchen: singuläre Ecken neben dieser Stelle oder ein anderes Netz</translation>
  </message>
  <message>
   <location filename="../../../solver/align/align.py" />
   <source>lines that follow the surface's own directions closely would run into each other, or bunch, here; these do less so</source>
   <translation>Linien, die den eigenen Richtungen der Fläche genau folgen, liefen hier ineinander oder drängten sich; diese tun es weniger</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>loop</source>
   <translation>Schleife</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lying</source>
   <translation>liegend</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>map</source>
   <translation>Abwicklung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>max {:.0f} %</source>
   <translation>max. {:.0f} %</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>max {:.3g} mm</source>
   <translation>max. {:.3g} mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>medial mesh</source>
   <translation>Mittelnetz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>membrane</source>
   <translation>Membran</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>meshes</source>
   <translation>Netze</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>mirror</source>
   <translation>spiegeln</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>mitred</source>
   <translation>auf Gehrung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>most of the surface bulges (positive Gauss curvature), and there it has no asymptotic lines</source>
   <translation>der größte Teil der Fläche wölbt sich (positive Gauß-Krümmung), und dort gibt es keine Asymptotenlinien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>mu</source>
   <translation>mu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>multi-net</source>
   <translation>Multinetz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>names and marks are written so</source>
   <translation>so werden Namen und Zeichen geschrieben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>near the net</source>
   <translation>beim Netz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>no</source>
   <translation>nein</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>no beams are made along the boundary</source>
   <translation>längs des Randes entstehen keine Träger</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>nodes</source>
   <translation>Knoten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>none</source>
   <translation>keine</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>not asked for</source>
   <translation>nicht verlangt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>not at all</source>
   <translation>gar nicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>not limited</source>
   <translation>unbegrenzt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>nothing</source>
   <translation>nichts</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>nothing (on the net itself)</source>
   <translation>nichts (Netz selbst)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>nu</source>
   <translation>nu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>offset</source>
   <translation>Versatz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>on the face diagonals</source>
   <translation>auf den Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>on the surface (S)</source>
   <translation>auf der Fläche (S)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one for all parts</source>
   <translation>eine für alle Teile</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one for each system</source>
   <translation>eine für jedes System</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one layer</source>
   <translation>eine Lage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one layer has slots where strips cross, two have bolt holes</source>
   <translation>eine Lage hat Schlitze, wo Streifen sich kreuzen, zwei haben Schraubenlöcher</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>one section for all</source>
   <translation>ein Querschnitt für alle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one workbook holds all lists, and masses with a column for prices</source>
   <translation>eine Arbeitsmappe enthält alle Listen und Massen mit einer Spalte für Preise</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one, in place</source>
   <translation>eine, am Ort</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one-sheeted hyperboloid</source>
   <translation>einschaliges Hyperboloid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>orient</source>
   <translation>orientieren</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>orthogonal</source>
   <translation>orthogonal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>outlines grow by half this width of a cut</source>
   <translation>Umrisse wachsen um die halbe Breite der Schnittfuge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>panels</source>
   <translation>Paneele</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>panels are flat and their corners right as they are: no exact net moves them</source>
   <translation>die Platten sind schon eben und ihre Ecken rechtwinklig: kein exaktes Netz bewegt sie</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>panels are flat as they are, and stay so in a planar net (--net planar); creases are askew to each other, so that corners are not right, and an exact principal net leaves the roof</source>
   <translation>die Platten sind schon eben und bleiben es in einem ebenen Netz (--net planar); Kanten stehen schief zueinander, sodass Ecken nicht rechtwinklig sind, und ein exaktes Hauptkrümmungsnetz verlässt das Dach</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>panels reach this far under pressure plates, by default 15 mm or as glass needs</source>
   <translation>so weit reichen Platten unter die Pressleisten, standardmäßig 15 mm oder wie Glas es braucht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parallel</source>
   <translation>parallel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>parallel to the screen (V)</source>
   <translation>parallel zum Bildschirm (V)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parameter</source>
   <translation>Parameter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts are blocks, plain lines or files</source>
   <translation>Teile sind Blöcke, bloße Linien oder Dateien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts are nested on sheets of this size</source>
   <translation>Teile werden auf Tafeln dieser Größe geschachtelt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts in 3DM are meshes, or solids where their sides are plane</source>
   <translation>Teile in 3DM sind Netze, oder Körper, wo ihre Seiten eben sind</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts keep so far from each other and from the rim</source>
   <translation>so weit bleiben Teile voneinander und vom Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts may turn</source>
   <translation>Teile dürfen drehen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts may turn on the sheet as its grain says</source>
   <translation>Teile drehen sich auf der Tafel, wie ihre Faserrichtung es erlaubt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts that agree within this are equal: one drawing, with how many are cut from it</source>
   <translation>Teile, die auf dieses Maß übereinstimmen, sind gleich: eine Zeichnung mit ihrer Anzahl</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pieces of panels at the border that are narrower than this are slivers</source>
   <translation>Stücke von Platten am Rand, die schmaler sind, sind Splitter</translation>
  </message>
  <message>
   <location filename="../../../solver/align/prepare.py" />
   <source>pinholes are closed: {}, {} across at most</source>
   <translation>kleine Löcher sind geschlossen: {}, höchstens {} weit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plain</source>
   <translation>einfarbig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plain lines</source>
   <translation>nur Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plan, sheets, a typical node and typical parts are drawn with dimensions, to scale</source>
   <translation>Grundriss, Tafeln, ein typischer Knoten und typische Teile werden mit Maßen gezeichnet, im Maßstab</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>planar</source>
   <translation>planar</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>planar-lines</source>
   <translation>planar-lines</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>planar: flat faces</source>
   <translation>planar: ebene Flächen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plane lines: flat beams</source>
   <translation>ebene Linien: ebene Träger</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plate</source>
   <translation>Blech</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plates of this family run through where two cross, both by half laps</source>
   <translation>Platten dieser Familie laufen durch, wo zwei sich kreuzen, beide mit Überblattung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plywood</source>
   <translation>Sperrholz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pressure plates and caps are this wide, by default 50 mm or as wide as glass needs</source>
   <translation>so breit sind Press- und Deckleisten, standardmäßig 50 mm oder wie Glas es braucht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pressure plates and caps hold the panels, or structural silicone on adapters</source>
   <translation>Press- und Deckleisten halten die Platten, oder tragendes Silikon auf Adaptern</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>principal</source>
   <translation>Hauptkrümmung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>principal stress: equilibrium</source>
   <translation>Spannung: Gleichgewicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>principal: flat panels</source>
   <translation>Hauptlinien: ebene Platten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pseudo-geodesic</source>
   <translation>pseudo-geodesic</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pseudo-geodesic: tilted</source>
   <translation>pseudogeodätisch: geneigt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>quads</source>
   <translation>Vierecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>quads have edges about this long</source>
   <translation>Kanten der Vierecke sind etwa so lang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>quarter</source>
   <translation>Viertel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>range: give both numbers, or none for an automatic range</source>
   <translation>Bereich: beide Zahlen angeben, oder keine für einen automatischen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rectangle</source>
   <translation>Rechteck</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rests of bars from this length on are kept</source>
   <translation>Reste von Stäben werden ab dieser Länge behalten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>ring</source>
   <translation>Ring</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rotational</source>
   <translation>rotatorisch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>round</source>
   <translation>rund</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rows are cut along lines of the net into pieces of at most this length</source>
   <translation>Reihen werden an Linien des Netzes in Stücke von höchstens dieser Länge geschnitten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>scherk</source>
   <translation>Scherk</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>second</source>
   <translation>zweites</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>sharp corners</source>
   <translation>scharfe Ecken</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>sheets come in these sizes too, mm; the smallest that will do is taken</source>
   <translation>Platten gibt es auch in diesen Größen, mm; genommen wird die kleinste, die reicht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>silicone</source>
   <translation>Silikon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>slivers at the border become part of their neighbours where they can, or are left out</source>
   <translation>Splitter am Rand werden, wo es geht, Teil ihrer Nachbarn oder weggelassen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>slots and hubs leave this much air</source>
   <translation>Schlitze und Naben lassen so viel Luft</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>slots have round corners for a milling cutter of this diameter</source>
   <translation>Schlitze haben runde Ecken für einen Fräser dieses Durchmessers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>snap</source>
   <translation>anlegen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>snet</source>
   <translation>S-Netz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>socket</source>
   <translation>Hülse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids</source>
   <translation>Körper</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids have the rounded corners and roots of a section of the catalogue</source>
   <translation>Körper haben die runden Ecken und Ausrundungen eines Querschnitts des Katalogs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids share a file, have one a system, or lie in one without places</source>
   <translation>Körper teilen sich eine Datei, haben eine je System oder liegen ohne Platzierungen in einer</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids that agree within this are one product of the file with several places</source>
   <translation>Körper, die bis auf dies gleich sind, sind ein Produkt der Datei an mehreren Orten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>sphere</source>
   <translation>Kugel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spherical stars</source>
   <translation>sphärische Sterne</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spliced beams have a splice after so many nodes, 0 for none</source>
   <translation>gestoßene Träger haben nach so vielen Knoten einen Stoß, 0 für keinen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spliced-u</source>
   <translation>gestoßen-u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spliced-v</source>
   <translation>gestoßen-v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>square</source>
   <translation>rechtwinklig</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>stainless</source>
   <translation>Edelstahl</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>standing</source>
   <translation>stehend</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>star</source>
   <translation>Stern</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>stay near {}</source>
   <translation>nahe {} bleiben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>steel</source>
   <translation>Stahl</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>straight</source>
   <translation>gerade</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>strengthened-glass</source>
   <translation>Glas, TVG</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>stress</source>
   <translation>Spannung</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>strip</source>
   <translation>Streifen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>strips are cut from this length; longer ones are spliced</source>
   <translation>Streifen werden aus dieser Länge geschnitten; längere werden gestoßen</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>stroke {} runs at {:.0f} degrees to the lines of a {} net on average: the net follows it, but an exact one near to this surface does not; draw it along these lines, or leave the net as it is aligned</source>
   <translation>Kurve {} verläuft im Mittel unter {:.0f} Grad zu den Linien eines Netzes der Art {}: das Netz folgt ihr, ein exaktes nahe dieser Fläche aber nicht; sie entlang dieser Linien zeichnen oder das Netz lassen, wie es ausgerichtet ist</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>subdivide</source>
   <translation>unterteilen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>surface</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/multinets.py" />
   <source>t from {} to {}, admissible from {} on</source>
   <translation>t von {} bis {}, zulässig ab {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/multinets.py" />
   <source>t from {} to {}, admissible from {} to {}</source>
   <translation>t von {} bis {}, zulässig von {} bis {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tangent-developable</source>
   <translation>Tangentenfläche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tension only</source>
   <translation>nur Zug</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the axes unroll to lines of this kind</source>
   <translation>die Achsen wickeln zu Linien dieser Art ab</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the base plates lie this far below the vertices</source>
   <translation>so weit liegen die Fußplatten unter den Ecken</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams are joined by hubs or sockets</source>
   <translation>die Träger sind durch Naben oder Hülsen verbunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams are this high</source>
   <translation>die Träger sind so hoch</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams have this cross section, or one of the catalogue such as HEB160</source>
   <translation>die Träger haben diesen Querschnitt oder einen des Katalogs wie HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams meet like this at a node</source>
   <translation>so treffen sich die Träger an einem Knoten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the bolt holes have this diameter</source>
   <translation>die Schraubenlöcher haben diesen Durchmesser</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>the border runs at {:.0f} degrees to the lines of curvature on average: an exact principal net leaves it; a planar one with some millimetres of flatness, which glides along its boundary, keeps it</source>
   <translation>der Rand verläuft im Mittel unter {:.0f} Grad zu den Krümmungslinien: ein exaktes Hauptkrümmungsnetz verlässt ihn; ein ebenes mit einigen Millimetern Ebenheit, das an seinem Rand gleitet, hält ihn ein</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the border that is held twists the surface by {:.1f} degrees between the vertices {} and {}, where this net allows hardly any: let the border leave its curve and trim it afterwards</source>
   <translation>der gehaltene Rand verwindet die Fläche um {:.1f} Grad zwischen den Ecken {} und {}, wo dieses Netz kaum etwas zulässt: den Rand seine Kurve verlassen lassen und danach beschneiden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the edge beam has this cross section, or one of the catalogue such as HEB160</source>
   <translation>der Randträger hat diesen Querschnitt oder einen des Katalogs wie HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the edge beam is this high, by default as high as the beams</source>
   <translation>so hoch ist der Randträger, sonst so hoch wie die Träger</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the edge beam is this wide, by default as thick as the plates or 60 mm</source>
   <translation>so breit ist der Randträger, sonst so dick wie die Bleche oder 60 mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the family nearer to it</source>
   <translation>die nähere Schar</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the flanges are this thick, by default as thick as the plates</source>
   <translation>die Flansche sind so dick, ohne Angabe so dick wie die Bleche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the hubs have a hole of this diameter along their axis</source>
   <translation>die Naben haben ein Loch dieses Durchmessers längs ihrer Achse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the hubs measure this across their faces</source>
   <translation>so viel messen die Naben über ihre Flächen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the joint between two panels is this wide</source>
   <translation>die Fuge zwischen zwei Platten ist so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the joint between two patches is this wide</source>
   <translation>die Fuge zwischen zwei Flächenstücken ist so breit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>the level of its lowest vertex</source>
   <translation>die Höhe seiner tiefsten Ecke</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the library may take so many seconds</source>
   <translation>die Bibliothek darf so viele Sekunden brauchen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the lines bend with the surface, where this net asks for asymptotic lines: begin with a net along curvature with lines for asymptotic-angle, near to the surface</source>
   <translation>die Linien krümmen sich mit der Fläche, während dieses Netz asymptotische Linien verlangt: mit einem Netz entlang der Krümmung mit Linien für asymptotic-angle beginnen, nahe der Fläche</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the lines do not follow the curvature of the surface, as this net has to, but those of its diagonal mesh do: make a diagonal mesh first</source>
   <translation>die Linien folgen nicht der Krümmung der Fläche, wie dieses Netz es muss, aber die seines Diagonalnetzes tun es: zuerst ein Diagonalnetz machen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the lines do not follow the curvature of the surface, as this net has to: take a start whose lines do</source>
   <translation>die Linien folgen nicht der Krümmung der Fläche, wie dieses Netz es muss: einen Anfang nehmen, dessen Linien es tun</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the louvres are turned by this angle about their lines</source>
   <translation>die Sonnenlamellen sind um diesen Winkel um ihre Linien gedreht</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the louvres turn about lines of this family</source>
   <translation>die Sonnenlamellen drehen um Linien dieser Schar</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the model's origin is there on site, in metres</source>
   <translation>dort liegt der Ursprung des Modells auf dem Bau, in Metern</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the model's x axis is turned so far from east</source>
   <translation>so weit ist die x-Achse des Modells von Osten gedreht</translation>
  </message>
  <message>
   <location filename="../../../solver/align/symmetry.py" />
   <source>the net is symmetric in {}</source>
   <translation>das Netz ist symmetrisch zu {}</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>the opening at {}, {} across, is too small for faces of this size: lines run over it; a shorter edge keeps it</source>
   <translation>die Öffnung bei {}, {} weit, ist zu klein für Maschen dieser Größe: Linien laufen über sie hinweg; eine kürzere Kante erhält sie</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the other variant of this net, on or off the diagonals, is much nearer</source>
   <translation>die andere Variante dieses Netzes, auf den Diagonalen oder nicht, liegt viel näher</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the panels are flat, or bent cold into faces that are not planar</source>
   <translation>die Platten sind eben oder kalt in nicht ebene Flächen gebogen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the panels are this thick, by default as thick as the plates</source>
   <translation>die Platten sind so dick, ohne Angabe so dick wie die Bleche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the panels' corners are cut off beside hubs, or the panels lifted over them</source>
   <translation>neben Naben sind die Ecken der Platten abgeschnitten, oder die Platten über sie gehoben</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the parts lie above the net, about it or below it</source>
   <translation>die Teile liegen über dem Netz, mittig darin oder darunter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the plates are this thick</source>
   <translation>die Bleche sind so dick</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the plates stand this deep in the sockets</source>
   <translation>die Bleche stehen so tief in den Hülsen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the posts are round tubes of this diameter</source>
   <translation>die Pfosten sind Rundrohre dieses Durchmessers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the profile's own</source>
   <translation>der des Profils</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the saw cut behind each part of a bar is this wide</source>
   <translation>so breit ist der Sägeschnitt hinter jedem Teil eines Stabes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the shape is doubly curved and will be bent towards a developable surface</source>
   <translation>die Form ist doppelt gekrümmt und wird zu einer abwickelbaren Fläche hin gebogen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the sides of the panels are square, or bevelled along the beams</source>
   <translation>die Seiten der Platten sind rechtwinklig, oder längs der Träger abgeschrägt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the solids are smooth instead of faceted</source>
   <translation>die Körper sind glatt statt facettiert</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the stock loses this much at each end</source>
   <translation>die Lagerlänge verliert so viel an jedem Ende</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips are made of plane faces or twisted</source>
   <translation>die Streifen sind aus ebenen Flächen oder verwunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips are this wide</source>
   <translation>die Streifen sind so breit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips end square before the border, or along it</source>
   <translation>die Streifen enden rechtwinklig vor dem Rand oder an ihm entlang</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips go this far beyond their last vertex, by default half their width</source>
   <translation>so weit gehen die Streifen über ihre letzte Ecke hinaus, ohne Angabe um ihre halbe Breite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips stand on the surface, lie in it, or tilt as the net wants it</source>
   <translation>die Streifen stehen auf der Fläche, liegen in ihr oder neigen sich, wie das Netz es will</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the surface has asymptotic lines, as this net asks for, only where it bends both ways: take one that is a saddle all over, or another net</source>
   <translation>die Fläche hat asymptotische Linien, wie dieses Netz sie verlangt, nur dort, wo sie sich nach beiden Seiten krümmt: eine nehmen, die überall ein Sattel ist, oder ein anderes Netz</translation>
  </message>
  <message>
   <location filename="../../../solver/align/symmetry.py" />
   <source>the surface has no plane of symmetry; the net is made without</source>
   <translation>die Fläche hat keine Symmetrieebene; das Netz wird ohne gemacht</translation>
  </message>
  <message>
   <location filename="../../../solver/align/guides.py" />
   <source>the surface is flat or round: every direction is one of curvature; the lines run along its border</source>
   <translation>die Fläche ist eben oder rund: jede Richtung ist eine der Krümmung; die Linien laufen entlang ihres Randes</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>the surface is made of {} flat faces: lines run along all creases between them and along the border, where the net ends</source>
   <translation>die Fläche besteht aus {} ebenen Flächen: Linien laufen entlang aller Kanten zwischen ihnen und entlang des Randes, an dem das Netz endet</translation>
  </message>
  <message>
   <location filename="../../../solver/align/prepare.py" />
   <source>the surface is rough, by {} within an edge; the net is on a smooth one through it</source>
   <translation>die Fläche ist rau, um {} innerhalb einer Kante; das Netz liegt auf einer glatten durch sie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the walls of a tube along the edge are this thick</source>
   <translation>so dick sind die Wände eines Rohrs am Rand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the walls of the posts are this thick</source>
   <translation>so dick sind die Wände der Pfosten</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>these lists have order of assembly, weights, what meets at nodes, points to be surveyed</source>
   <translation>diese Listen haben Montagefolge, Gewichte, was sich an Knoten trifft, einzumessende Punkte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>these rows of item, unit and price give the lists' costs</source>
   <translation>aus diesen Zeilen von Posten, Einheit und Preis folgen die Kosten der Listen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>these vertices stand on feet: corners, boundary, or their numbers as 0,12,40</source>
   <translation>diese Ecken stehen auf Füßen: corners, boundary oder ihre Nummern wie 0,12,40</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>those of its file</source>
   <translation>die seiner Datei</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>through</source>
   <translation>durchlaufend</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>through-u</source>
   <translation>u durchlaufend</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>through-v</source>
   <translation>v durchlaufend</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tilted</source>
   <translation>geneigt</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>timber</source>
   <translation>Holz</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>toughened-glass</source>
   <translation>Glas, ESG</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>transform</source>
   <translation>abbilden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>translational</source>
   <translation>Schiebfläche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>trim</source>
   <translation>beschneiden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tube</source>
   <translation>Rohr</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tubes of one section differ so much in height</source>
   <translation>so verschieden hoch sind Rohre eines Querschnitts</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>twisted</source>
   <translation>verwunden</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>two-sheeted hyperboloid</source>
   <translation>zweischaliges Hyperboloid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>u</source>
   <translation>u</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>u lines</source>
   <translation>u-Linien</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>unduloid</source>
   <translation>Unduloid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>v</source>
   <translation>v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>v lines</source>
   <translation>v-Linien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>vertex</source>
   <translation>Ecke</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>vertex {} drawn to its place</source>
   <translation>Ecke {} an ihren Ort gezogen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>wave</source>
   <translation>Welle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>web</source>
   <translation>web</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>web: three layers of slats</source>
   <translation>Gewebe: drei Scharen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>weld</source>
   <translation>verschweißen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>whole rows</source>
   <translation>ganze Reihen</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>x</source>
   <translation>x</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>x,y</source>
   <translation>x,y</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>x,y,xy</source>
   <translation>x,y,xy</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>y</source>
   <translation>y</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>yes</source>
   <translation>ja</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>z</source>
   <translation>z</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{:,} vertices, {:,} faces</source>
   <translation>{:,} Ecken, {:,} Maschen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{:,} vertices, {:,} variables, {:,} constraints, {} a step</source>
   <translation>{:,} Ecken, {:,} Unbekannte, {:,} Bedingungen, {} je Schritt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>{:.0f} a second</source>
   <translation>{:.0f} je Sekunde</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>{:.3g} to {:.3g} kN</source>
   <translation>{:.3g} bis {:.3g} kN</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>{} (baked)</source>
   <translation>{} (festgeschrieben)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>{} cannot be started.</source>
   <translation>{} kann nicht gestartet werden.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>{} drawn</source>
   <translation>{} gezeichnet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>{} edges</source>
   <translation>{} Kanten</translation>
  </message>
  <message>
   <location filename="../../../solver/align/align.py" />
   <source>{} faces are folded; give a shorter edge, or smooth the surface there</source>
   <translation>{} Maschen sind gefaltet; eine kürzere Kante angeben oder die Fläche dort glätten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/display.py" />
   <source>{} is hidden: nothing of this is seen yet</source>
   <translation>{} ist ausgeblendet: davon ist noch nichts zu sehen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>{} is outdated: its source has changed since it was optimised or dragged</source>
   <translation>{} ist veraltet: die Quelle hat sich geändert, seit es optimiert oder gezogen wurde</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{} kinds of edges within {}, {} before.</source>
   <translation>{} Arten von Kanten auf {}, vorher {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{} kinds of nodes within {}, {} before.</source>
   <translation>{} Arten von Knoten auf {}, vorher {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{} kinds of panels within {}, {} before.</source>
   <translation>{} Arten von Paneelen auf {}, vorher {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>{} lines</source>
   <translation>{} Linien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>{} mesh</source>
   <translation>{} Netz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>{} of them exceed a limit, such as {}: {}</source>
   <translation>{} davon überschreiten eine Grenze, etwa {}: {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>{} of {} chosen</source>
   <translation>{} von {} gewählt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>{} of {} parts exceed a limit, see report.html</source>
   <translation>{} von {} Teilen überschreiten eine Grenze, siehe report.html</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>{} on the diagonals</source>
   <translation>{} auf den Diagonalen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>{} parts, {} to {}</source>
   <translation>{} Teile, {} bis {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>{} points</source>
   <translation>{} Punkte</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/mirror.py" />
   <source>{} separate components</source>
   <translation>{} getrennte Teile</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{} separate parts: not all faces meet along whole sides</source>
   <translation>{} getrennte Teile: nicht alle Flächen treffen sich entlang ganzer Seiten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>{} stays as it is, though its source has changed: optimise it again</source>
   <translation>{} bleibt, wie es ist, obwohl die Quelle sich geändert hat: neu optimieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/residual_plot.py" />
   <source>{} steps</source>
   <translation>{} Schritte</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{} vertices lie beside a seam and could not be joined</source>
   <translation>{} Ecken liegen neben einer Naht und konnten nicht verbunden werden</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/mirror.py" />
   <source>{} vertices merged</source>
   <translation>{} Ecken vereinigt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/aligning.py" />
   <source>{} vertices with {} lines</source>
   <translation>{} Ecken mit {} Linien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/source_panel.py" />
   <source>{} vertices, {} quads</source>
   <translation>{} Ecken, {} Vierecke</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>{} waits to be built anew: Refresh or Update structures does it</source>
   <translation>{} wartet darauf, neu gebaut zu werden: mit Aktualisieren oder Tragwerke aktualisieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>{} with {} lines</source>
   <translation>{} mit {} Linien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>{}, diag.</source>
   <translation>{} diag.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>{}: far from the origin; put near it, and back where it is exported
</source>
   <translation>{}: weit vom Ursprung; in seine Nähe gesetzt, und beim Export zurück
</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>{}: {:,} parts, {:,.1f} kg</source>
   <translation>{}: {:,} Teile, {:,.1f} kg</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{}: {} quads at the border had no room and were left out</source>
   <translation>{}: {} Vierecke am Rand hatten keinen Platz und wurden weggelassen</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{}: {} quads at the border have a straight corner</source>
   <translation>{}: {} Vierecke am Rand haben eine gestreckte Ecke</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>{}: {} vertices, {} faces of {} corners, edge ratio {:.2f}</source>
   <translation>{}: {} Punkte, {} Flächen mit {} Ecken, Kantenverhältnis {:.2f}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>{}: {} vertices, {} quads, {} irregular, edge ratio {:.2f}</source>
   <translation>{}: {} Ecken, {} Vierecke, {} irregulär, Kantenverhältnis {:.2f}</translation>
  </message>
 </context>
 <context>
  <name>OrthoPreferences</name>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Ask once a session, when the workbench is opened</source>
   <translation>Einmal je Sitzung fragen, beim Öffnen des Arbeitsbereichs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Axis that points up</source>
   <translation>Achse, die nach oben zeigt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Beams</source>
   <translation>Träger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colour of new beams</source>
   <translation>Farbe neuer Träger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colour of new panels</source>
   <translation>Farbe neuer Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colour of the faces of a net where no colour map is shown</source>
   <translation>Farbe der Maschen eines Netzes, wo keine Farbkarte gezeigt wird</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colours of new objects</source>
   <translation>Farben neuer Objekte</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Fabrication files</source>
   <translation>Fertigungsdateien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Follow at once up to</source>
   <translation>Sofort folgen bis</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Gap between panels</source>
   <translation>Fuge zwischen Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>General</source>
   <translation>Allgemein</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Height of beams</source>
   <translation>Höhe der Träger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Height of new beams, along the axes</source>
   <translation>Höhe neuer Träger, längs der Achsen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Import</source>
   <translation>Import</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Nets</source>
   <translation>Netze</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Offer to install missing Python packages</source>
   <translation>Anbieten, fehlende Python-Pakete zu installieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Optimisation</source>
   <translation>Optimierung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Packages</source>
   <translation>Pakete</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Panels</source>
   <translation>Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Processes that share the work on parts; worth it from some hundred parts on</source>
   <translation>Prozesse, die sich die Arbeit an Teilen teilen; lohnt sich ab einigen hundert Teilen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Sizes that panels start with</source>
   <translation>Größen, mit denen die Eingabefelder beginnen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Sparse solver</source>
   <translation>Dünnbesetzter Löser</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Structures and flat patterns</source>
   <translation>Tragwerke und Abwicklungen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of beams</source>
   <translation>Dicke der Träger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of new panels</source>
   <translation>Dicke neuer Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of panels</source>
   <translation>Dicke der Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of the plates of new beams</source>
   <translation>Dicke der Bleche neuer Träger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Those that take longer to build keep their shape and a mark when their net changes, until Refresh or Update structures</source>
   <translation>Was länger zu bauen braucht, behält bei einer Änderung des Netzes seine Form und eine Marke, bis zu Aktualisieren oder Tragwerke aktualisieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Unit of imported meshes</source>
   <translation>Einheit importierter Netze</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>What solves the linear system of each step; rslab is the faster one, where it is installed</source>
   <translation>Was das Gleichungssystem jedes Schritts löst; rslab ist der schnellere, wo er installiert ist</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Which axis of a mesh file points up; y is turned to FreeCAD's z</source>
   <translation>Welche Achse einer Netzdatei nach oben zeigt; y wird auf FreeCADs z gedreht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Which unit the numbers of a mesh file are in</source>
   <translation>In welcher Einheit die Zahlen einer Netzdatei sind</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Width of the joint between neighbouring panels</source>
   <translation>Breite der Fuge zwischen benachbarten Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Workers</source>
   <translation>Prozesse</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>as the file says, else mm</source>
   <translation>wie die Datei sagt, sonst mm</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>the fastest installed</source>
   <translation>der schnellste installierte</translation>
  </message>
 </context>
 <context>
  <name>Ortho_AlignedNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A net on the selected CAD faces along the lines that an exact net has there, which overhangs their border; edges, wires and sketches that are selected too it runs along</source>
   <translation>Ein Netz auf den gewählten CAD-Flächen entlang der Linien, die ein genaues Netz dort hat; es ragt über ihren Rand; an Kanten, Kantenzügen und Skizzen, die auch gewählt sind, läuft es entlang</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Aligned net</source>
   <translation>Ausgerichtetes Netz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Net along curvature</source>
   <translation>Netz entlang der Krümmung</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Arches</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Arches</source>
   <translation>Bögen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a plate that is cut flat along every line of the selected net that lies in a plane</source>
   <translation>Eine flach geschnittene Platte entlang jeder Linie des gewählten Netzes setzen, die in einer Ebene liegt</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Bake</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Bake to plain features</source>
   <translation>Als einfache Objekte festschreiben</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Copy the selected nets and structures as Part features and meshes that need no add-on</source>
   <translation>Gewählte Netze und Tragwerke als Part-Objekte und Netze kopieren, die keine Erweiterung brauchen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Beams</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Beams</source>
   <translation>Träger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put torsion-free beams on the edges or parameter lines of the selected net</source>
   <translation>Torsionsfreie Träger auf Kanten oder Parameterlinien des gewählten Netzes setzen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_BentPanels</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Bent panels</source>
   <translation>Gebogene Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put one bent plate in every row of faces of the selected net</source>
   <translation>In jede Reihe von Maschen des gewählten Netzes eine gebogene Platte setzen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_ChangeNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>Derive, subdivide, transform or weld nets into a new one that follows</source>
   <translation>Netze ableiten, unterteilen, abbilden oder verschweißen zu einem neuen, das folgt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>Net from nets</source>
   <translation>Netz aus Netzen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Check</name>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Check</source>
   <translation>Prüfen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Measure the selected net and say which kinds of nets it is near to</source>
   <translation>Das gewählte Netz messen und sagen, welchen Arten von Netzen es nahe ist</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Derived</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Derived mesh</source>
   <translation>Abgeleitetes Netz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>The diagonal, medial or checkerboard mesh of the selected net, or its Christoffel dual</source>
   <translation>Das Diagonal-, Mittellinien- oder Schachbrettnetz des gewählten Netzes oder sein Christoffel-Dual</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Display</name>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Choose the colour map and the overlays of the selected net</source>
   <translation>Farbkarte und Überlagerungen des gewählten Netzes wählen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Display</source>
   <translation>Anzeige</translation>
  </message>
 </context>
 <context>
  <name>Ortho_DrawingPage</name>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Drawing page</source>
   <translation>Zeichnungsblatt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Show each sheet of the selected flat patterns on a page to print</source>
   <translation>Jede Tafel der gewählten Abwicklungen auf einem Blatt zum Drucken zeigen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_EdgeBeam</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Edge beam</source>
   <translation>Randträger</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a beam along the border of the selected net, at which beams and panels end</source>
   <translation>Einen Träger an den Rand des gewählten Netzes setzen, an dem Träger und Platten enden</translation>
  </message>
 </context>
 <context>
  <name>Ortho_EditNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Drag vertices of the selected net; the others follow so that it stays its kind of net</source>
   <translation>Ecken des gewählten Netzes ziehen; die anderen folgen, sodass es seine Art von Netz bleibt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Edit net</source>
   <translation>Netz bearbeiten</translation>
  </message>
 </context>
 <context>
  <name>Ortho_EllipticNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>An orthogonal multi-net from a curve in elliptic coordinates</source>
   <translation>Ein orthogonales Multinetz aus einer Kurve in elliptischen Koordinaten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Elliptic multi-net</source>
   <translation>Elliptisches Multinetz</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Examples</name>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>A canopy made orthogonal and planar, with flat beams and panels</source>
   <translation>Ein Dach, orthogonal und eben gemacht, mit ebenen Trägern und Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>A form-found dome, then flat panels that meet at right angles</source>
   <translation>Eine Kuppel aus der Formfindung, dann ebene Platten, die sich rechtwinklig treffen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>A soap film and an asymptotic net on it: laths that unroll straight</source>
   <translation>Eine Seifenhaut und ein asymptotisches Netz darauf: Lamellen, die gerade abwickeln</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Developable sheets</source>
   <translation>Abwickelbare Bleche</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Four nets that are orthogonal exactly, in all their rectangles</source>
   <translation>Vier Netze, die exakt orthogonal sind, in allen ihren Rechtecken</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Hanging net turned over</source>
   <translation>Hängendes Netz, umgedreht</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Minimal gridshell</source>
   <translation>Minimale Gitterschale</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>One curved sheet made developable in two ways, corners held</source>
   <translation>Ein gekrümmtes Blech, auf zwei Arten abwickelbar gemacht, Ecken gehalten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Orthogonal multi-nets</source>
   <translation>Orthogonale Multinetze</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Roof of beams and panels</source>
   <translation>Dach aus Trägern und Platten</translation>
  </message>
 </context>
 <context>
  <name>Ortho_ExportFabrication</name>
  <message>
   <location filename="../../../freecad_ortho/commands/export_fabrication.py" />
   <source>Export fabrication files</source>
   <translation>Fertigungsdateien exportieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/export_fabrication.py" />
   <source>Write solids (STEP), flat patterns and sheets (DXF), lists (CSV) and reports of the selected structures</source>
   <translation>Körper (STEP), Abwicklungen und Tafeln (DXF), Listen (CSV) und Berichte der gewählten Tragwerke schreiben</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FaceNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Net on faces</source>
   <translation>Netz auf Flächen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Sample the selected CAD faces along their parameter lines, joined where they meet</source>
   <translation>Die gewählten CAD-Flächen längs ihrer Parameterlinien abtasten, verbunden, wo sie sich treffen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Feet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put corners, the boundary or some vertices of the selected net on posts with base plates</source>
   <translation>Ecken, Rand oder einzelne Punkte des gewählten Netzes auf Pfosten mit Fußplatten stellen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Support feet</source>
   <translation>Stützenfüße</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FlatPatterns</name>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Flat patterns</source>
   <translation>Abwicklungen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Lay the parts of the selected structures flat, in rows or on sheets</source>
   <translation>Die Teile der gewählten Tragwerke flach auslegen, in Reihen oder auf Tafeln</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FlipNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Flip net</source>
   <translation>Netz wenden</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Turn the other side of the selected net up; an arrow shows it, offsets and parts follow</source>
   <translation>Die andere Seite des gewählten Netzes nach oben wenden; ein Pfeil zeigt sie, Versätze und Teile folgen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FormNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A membrane or cable net in equilibrium that starts from the selected net</source>
   <translation>Eine Membran oder ein Seilnetz im Gleichgewicht, ausgehend vom gewählten Netz</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Form-finding</source>
   <translation>Formfindung</translation>
  </message>
 </context>
 <context>
  <name>Ortho_ImportNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/import_net.py" />
   <source>Import quad mesh</source>
   <translation>Vierecksnetz importieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/import_net.py" />
   <source>Read an OBJ, PLY, OFF, JSON or VTK file and keep its quads as a net</source>
   <translation>Eine OBJ-, PLY-, OFF-, JSON- oder VTK-Datei lesen und ihre Vierecke als Netz behalten</translation>
  </message>
 </context>
 <context>
  <name>Ortho_InstallPackages</name>
  <message>
   <location filename="../../../freecad_ortho/commands/install_packages.py" />
   <source>Install missing packages</source>
   <translation>Fehlende Pakete installieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/install_packages.py" />
   <source>Install the Python packages that the workbench needs and FreeCAD does not find</source>
   <translation>Die Python-Pakete installieren, die der Arbeitsbereich braucht und FreeCAD nicht findet</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Lamellas</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Lamellas</source>
   <translation>Lamellen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a strip that unrolls flat along every parameter line of the selected net</source>
   <translation>Längs jeder Parameterlinie des gewählten Netzes einen Streifen setzen, der flach abwickelt</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Louvres</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Louvres</source>
   <translation>Sonnenlamellen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a slat on the midpoints of every face of the selected net</source>
   <translation>In jede Masche des gewählten Netzes eine Lamelle auf die Mittelpunkte setzen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_MultiNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Draw a polyline on a quadric; the orthogonal multi-net that it determines follows at once</source>
   <translation>Einen Linienzug auf eine Quadrik zeichnen; das orthogonale Multinetz, das er bestimmt, folgt sofort</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Multi-net</source>
   <translation>Multinetz</translation>
  </message>
 </context>
 <context>
  <name>Ortho_NewNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>A net from numbers, CAD faces, triangles or form-finding</source>
   <translation>Ein Netz aus Zahlen, CAD-Flächen, Dreiecken oder Formfindung</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>New net</source>
   <translation>Neues Netz</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Nodes</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Nodes</source>
   <translation>Knoten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a hub or a joint at the vertices of the selected net</source>
   <translation>An die Ecken des gewählten Netzes eine Nabe oder ein Gelenk setzen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Offset</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A parallel net at an even distance</source>
   <translation>Ein paralleles Netz in gleichmäßigem Abstand</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Offset</source>
   <translation>Lage</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Optimise</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Move the vertices of the selected net until its faces are orthogonal and planar</source>
   <translation>Die Ecken des gewählten Netzes bewegen, bis seine Maschen orthogonal und eben sind</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Optimise</source>
   <translation>Optimieren</translation>
  </message>
 </context>
 <context>
  <name>Ortho_OptimiseAgain</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Optimise again</source>
   <translation>Noch einmal optimieren</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Optimise the selected nets, or all, as before where their sources have changed since</source>
   <translation>Die gewählten Netze, oder alle, wie zuvor optimieren, wo sich ihre Quellen seither geändert haben</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Panels</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Panels</source>
   <translation>Platten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a flat panel in every face of the selected net</source>
   <translation>In jede Masche des gewählten Netzes eine ebene Platte setzen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Patches</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Developable patches</source>
   <translation>Abwickelbare Flächen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Make the selected net of sheets that are cut flat and bent into place</source>
   <translation>Das gewählte Netz aus Blechen bauen, die flach zugeschnitten und in Form gebogen werden</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Primitive</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A net that is known exactly: sphere, catenoid, helicoid and others</source>
   <translation>Ein exakt bekanntes Netz: Kugel, Katenoid, Helikoid und andere</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Primitive</source>
   <translation>Grundform</translation>
  </message>
 </context>
 <context>
  <name>Ortho_QuadsFromMesh</name>
  <message>
   <location filename="../../../freecad_ortho/commands/remesh.py" />
   <source>Quads from triangles</source>
   <translation>Vierecke aus Dreiecken</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/remesh.py" />
   <source>Remesh the selected triangle mesh, or an STL, OBJ, PLY or GLB file, to a net of quads</source>
   <translation>Das gewählte Dreiecksnetz oder eine STL-, OBJ-, PLY- oder GLB-Datei in ein Netz aus Vierecken umbauen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Refine</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>More or fewer parameter lines of the selected net, or rows cut off</source>
   <translation>Mehr oder weniger Parameterlinien des gewählten Netzes, oder Reihen abgeschnitten</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Subdivide, coarsen, trim</source>
   <translation>Teilen, vergröbern, kürzen</translation>
  </message>
 </context>
 <context>
  <name>Ortho_SavePicture</name>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Save picture</source>
   <translation>Bild speichern</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Save what the 3D view shows, at any size</source>
   <translation>Speichern, was die 3D-Ansicht zeigt, in jeder Größe</translation>
  </message>
 </context>
 <context>
  <name>Ortho_StructuralCheck</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Check the grid shell on the selected net as a frame under loads</source>
   <translation>Die Gitterschale auf dem gewählten Netz als Stabwerk unter Lasten prüfen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Structural check</source>
   <translation>Statische Prüfung</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Transform</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Move, turn, scale, mirror, turn over or bend the selected net (Moebius transformation)</source>
   <translation>Das gewählte Netz verschieben, drehen, skalieren, spiegeln, wenden oder biegen (Möbius-Transformation)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Transform net</source>
   <translation>Netz abbilden</translation>
  </message>
 </context>
 <context>
  <name>Ortho_UpdateStructures</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Build those structures and flat patterns anew that wait because they take long</source>
   <translation>Jene Tragwerke und Abwicklungen neu bauen, die warten, weil sie lange dauern</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Update structures</source>
   <translation>Tragwerke aktualisieren</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Weld</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Join nets, or one with itself, where borders meet</source>
   <translation>Netze verbinden, oder eines mit sich selbst, wo Ränder sich treffen</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Weld nets</source>
   <translation>Netze verschweißen</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Analyse</source>
   <translation>&amp;Analysieren</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Design</source>
   <translation>&amp;Entwerfen</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Examples</source>
   <translation>&amp;Beispiele</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Fabricate</source>
   <translation>&amp;Fertigen</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Optimise</source>
   <translation>&amp;Optimieren</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Ortho</source>
   <translation>&amp;Ortho</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Ortho</source>
   <translation>Ortho</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Ortho Analyse</source>
   <translation>Ortho Analyse</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Ortho Design</source>
   <translation>Ortho Entwurf</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Ortho Fabricate</source>
   <translation>Ortho Fertigung</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Ortho Optimise</source>
   <translation>Ortho Optimierung</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Turn freeform quad meshes into buildings of flat beams and panels</source>
   <translation>Aus freien Vierecksnetzen Bauten aus ebenen Trägern und Platten machen</translation>
  </message>
 </context>
</TS>
