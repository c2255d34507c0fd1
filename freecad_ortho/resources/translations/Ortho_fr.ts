<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
 <context>
  <name>App::Property</name>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>All combinations, any of which can be drawn</source>
   <translation>Toutes les combinaisons, chacune peut être dessinée</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Anchor: four anchor bolts hold a base plate</source>
   <translation>Ancrage : quatre ancrages tiennent une platine</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>As ForcesAlong, of all combinations, one by one</source>
   <translation>Comme ForcesAlong, de toutes les combinaisons, l'une après l'autre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At hubs: the panels' corners are cut off beside hubs, or the panels lifted over them</source>
   <translation>Aux moyeux : près des moyeux, les coins des panneaux sont coupés, ou les panneaux relevés par-dessus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the larger one</source>
   <translation>En son sommet la surface a ce rayon de courbure, le plus grand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the smaller one</source>
   <translation>En son sommet la surface a ce rayon de courbure, le plus petit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At the border the net overhangs the surface, to be trimmed, or bends to follow it</source>
   <translation>Au bord, le réseau dépasse la surface, pour être coupé, ou se plie pour le suivre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Axial force of each member where it is used most, kN; tension positive</source>
   <translation>Effort normal de chaque barre là où elle travaille le plus, kN ; traction positive</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Balance is found in the deformed, imperfect shape</source>
   <translation>L'équilibre est trouvé dans la forme déformée et imparfaite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Beams or lamellas whose section and material count; empty: those given here</source>
   <translation>Poutres ou lamelles dont la section et le matériau comptent ; vide : ceux donnés ici</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Beams pass that twist by this at most; 0: any</source>
   <translation>Les poutres qui se vrillent d'autant au plus passent ; 0 : toutes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Beams that the parts lie on or join; empty: the net</source>
   <translation>Poutres sur lesquelles les pièces reposent ou qu'elles relient ; vide : le réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bend radius: folds have this radius inside, by default that of the thickness; 0 is automatic</source>
   <translation>Rayon de pliage : rayon intérieur des plis, sinon celui de l'épaisseur ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bending: the panels are flat, or bent cold into faces that are not planar</source>
   <translation>Cintrage : les panneaux sont plans, ou cintrés à froid dans des faces non planes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bite: joints of structural silicone are this wide</source>
   <translation>Largeur de joint : largeur des joints de silicone structurel</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Blue at and below this value (mm, 1/m, 1/m2, degrees) if not automatic</source>
   <translation>Bleu à cette valeur et en dessous (mm, 1/m, 1/m2, degrés) si non automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolt: beams are bolted with bolts of this size</source>
   <translation>Boulon : les poutres sont boulonnées avec cette taille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolts: a joint has so many bolts above each other</source>
   <translation>Boulons : nombre de boulons superposés d'un assemblage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cables have this force density; 0 is the same</source>
   <translation>Les câbles de bord ont cette densité de force ; 0 : la même</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cut: the strips end square before the border, or along it</source>
   <translation>Coupe au bord : les bandes finissent d'équerre avant le bord, ou le long de lui</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bore: the hubs have a hole of this diameter along their axis</source>
   <translation>Alésage : les moyeux ont un trou de ce diamètre le long de leur axe</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Buckling shape that is drawn; 1 is the first</source>
   <translation>Mode de flambement dessiné ; 1 est le premier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC nets: the vertex spheres have this radius; 0 is free</source>
   <translation>Réseaux CMC : les sphères des sommets ont ce rayon ; 0 : libre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: each direction has a length of its own</source>
   <translation>Réseaux de Tchebychev : chaque direction a sa propre longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: the edges are this long; 0 is free</source>
   <translation>Réseaux de Tchebychev : les arêtes ont cette longueur ; 0 : libre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clear distance: parts keep so far from each other and from the rim</source>
   <translation>Distance libre: distance entre les pièces et jusqu'au bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clearance: slots and hubs leave this much air; 0 is 1 mm, slots by material</source>
   <translation>Jeu : les encoches et les moyeux laissent ce jeu ; 0 : 1 mm, entailles selon le matériau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cleats: angles with bolts join strips where these end</source>
   <translation>Équerres : des équerres boulonnées joignent les bandes à leurs bouts</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Colour of the edges</source>
   <translation>Couleur des arêtes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Colour of the faces where no colour map is shown</source>
   <translation>Couleur des faces sans carte de couleurs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Combination whose forces and displacements are drawn, first order</source>
   <translation>Combinaison dont les efforts et déplacements sont dessinés, premier ordre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Combination whose forces are drawn as diagrams</source>
   <translation>Combinaison dont les efforts sont tracés en diagrammes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Counts, accuracy and masses, as JSON</source>
   <translation>Nombres, précision et masses, en JSON</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Cut parts along the border of the surface, where the net has one</source>
   <translation>Couper les pièces le long du bord de la surface, si le réseau en a un</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cutter: slots have round corners for a milling cutter of this diameter; 0 is sharp corners</source>
   <translation>Fraise : les fentes ont des coins ronds pour une fraise de ce diamètre ; 0 : coins vifs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Density in kg/m3; 0: that of the material</source>
   <translation>Densité en kg/m3 ; 0 : celle du matériau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Diagonals: a third layer lies along these diagonals, which brace the net</source>
   <translation>Diagonales: une troisième couche repose sur ces diagonales, qui contreventent le réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Displacements are drawn so many times as large; 0: as it fits</source>
   <translation>Les déplacements sont dessinés tant de fois plus grands ; 0 : selon la place</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Distortion: a patch is built up to this distortion of an edge</source>
   <translation>Distorsion : une surface est réalisée jusqu'à cette distorsion d'une arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Each vertex carries this load, a force along x, y and z</source>
   <translation>Chaque sommet porte cette charge, une force selon x, y et z</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Edge beam that the parts end at or lie on</source>
   <translation>Poutre de rive à laquelle les pièces s'arrêtent ou sur laquelle elles posent</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge cover: panels reach this far under pressure plates, by default 15 mm or as glass needs; 0 is automatic</source>
   <translation>Recouvrement : prise des panneaux sous les serreurs, par défaut 15 mm ou selon le besoin du verre ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge height: the edge beam is this high, by default as high as the beams; 0 is automatic</source>
   <translation>Hauteur de rive : hauteur de la poutre de rive, sinon celle des poutres ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge section: the edge beam has this cross section, or one of the catalogue such as HEB160</source>
   <translation>Profil de rive : la poutre de rive a cette section, ou une du catalogue comme HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge wall: the walls of a tube along the edge are this thick</source>
   <translation>Paroi du tube : épaisseur des parois d'un tube de rive</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge width: the edge beam is this wide, by default as thick as the plates or 60 mm; 0 is automatic</source>
   <translation>Largeur de rive : largeur de la poutre de rive, sinon l'épaisseur des plaques ou 60 mm ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Edges and faces that vertices glide on, exactly</source>
   <translation>Arêtes et faces sur lesquelles les sommets glissent exactement</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long</source>
   <translation>Les arêtes ont à peu près cette longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long, whatever the sampling</source>
   <translation>Les arêtes ont à peu près cette longueur, quel que soit l'échantillonnage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of nodes may be turned this far from the shape of their kind</source>
   <translation>Les arêtes des nœuds peuvent être tournées d'autant par rapport à la forme de leur type</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of the other family of lines are so many times as long</source>
   <translation>Les arêtes de l'autre famille de lignes sont autant de fois plus longues</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Edges, wires and sketches that lines of the net run along</source>
   <translation>Arêtes, fils et esquisses le long desquels courent des lignes du réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends of members are rigid, hinged, or have springs of this stiffness in kNm/rad</source>
   <translation>Les extrémités des barres sont rigides, articulées, ou ont des ressorts de cette raideur en kNm/rad (rigid, hinged ou le nombre)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends: the beams meet like this at a node</source>
   <translation>Extrémités : les poutres se joignent ainsi à un nœud</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every so many lines of u and v stay</source>
   <translation>Une ligne de u et de v reste sur ce nombre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces at inner irregular vertices are left out, or asked for right angles too, which no smooth surface has there</source>
   <translation>Les faces aux sommets irréguliers intérieurs sont laissées de côté, ou on leur demande aussi des angles droits, qu'aucune surface lisse n'a là</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces keep their shape the more of it there is, such as 10; none is usual; -1 is automatic</source>
   <translation>Plus il y en a, plus les faces gardent leur forme, par exemple 10 ; d'habitude aucun; -1 : automatique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Faces that the net is sampled from and stays linked to</source>
   <translation>Faces dont le réseau est échantillonné et auxquelles il reste lié</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Faces that the net stays near as far as it can</source>
   <translation>Faces dont le réseau reste proche autant que possible</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Few kinds are wanted of these parts, once the net is reached</source>
   <translation>On veut peu de types de ces pièces, une fois le réseau atteint</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>File that the net came from</source>
   <translation>Fichier d'où vient le réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flange thickness: the flanges are this thick, by default as thick as the plates; 0 is automatic</source>
   <translation>Épaisseur des semelles : les semelles ont cette épaisseur, par défaut celle des plats ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>Flat patterns that the picture shows</source>
   <translation>Développés que l'image montre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Fold: edges of metal panels are folded down by this</source>
   <translation>Pli : les bords des panneaux de tôle sont pliés vers le bas d'autant</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>Follow each change at once, if that does not take long; else only when asked to</source>
   <translation>Suivre chaque changement aussitôt, si ce n'est pas long ; sinon seulement sur demande</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot at: these vertices stand on feet: corners, boundary, or their numbers as 0,12,40</source>
   <translation>Pieds à : ces sommets posent sur des pieds : corners, boundary ou leurs numéros comme 0,12,40</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot height: the base plates lie this far below the vertices</source>
   <translation>Hauteur de pied : distance des platines sous les sommets</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot plate: base plates and caps are this thick</source>
   <translation>Platine de pied : épaisseur des platines de base et de tête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>For buckling and second order each member has so many pieces</source>
   <translation>Pour le flambement et le second ordre chaque barre a tant de morceaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>Force on each node of the mesh, N</source>
   <translation>Force sur chaque nœud du maillage, N</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Force that is drawn across the members, red where positive</source>
   <translation>Effort tracé perpendiculairement aux barres, rouge là où il est positif</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame width: pressure plates and caps are this wide, by default 50 mm or as wide as glass needs; 0 is automatic</source>
   <translation>Largeur de cadre : largeur des serreurs et capots, par défaut 50 mm ou selon le besoin du verre ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame: pressure plates and caps hold the panels, or structural silicone on adapters</source>
   <translation>Cadre : serreurs et capots tiennent les panneaux, ou du silicone structurel sur adaptateurs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gap: the joint between two panels is this wide</source>
   <translation>Joint : le joint entre deux panneaux a cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gap: the joint between two patches is this wide</source>
   <translation>Joint : le joint entre deux surfaces a cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gasket: gaskets below and above framed panels are this thick</source>
   <translation>Joint : épaisseur des joints sous et sur les panneaux en cadre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Gliding without an object: boundary, or such as z=0</source>
   <translation>Glissement sans objet : boundary, ou par exemple z=0</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Grain: parts may turn on the sheet as its grain says</source>
   <translation>Sens du fil : les pièces tournent sur la plaque selon le sens du fil</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Height of a sheet</source>
   <translation>Hauteur d'une tôle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Height: the beams are this high</source>
   <translation>Hauteur : les poutres ont cette hauteur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hole: the bolt holes have this diameter</source>
   <translation>Trou : les trous de boulons ont ce diamètre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>How many of these points each of the curves has</source>
   <translation>Combien de ces points a chacune des courbes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>How many vertices each face has, where some have more or fewer than four</source>
   <translation>Nombre de sommets de chaque face, là où certaines en ont plus ou moins de quatre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub diameter: the hubs measure this across their faces; 0 is 100 mm, of bolted ones what each needs</source>
   <translation>Diamètre du moyeu : les moyeux mesurent autant entre leurs faces ; 0 : 100 mm, boulonnés : selon le besoin</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub wall: bolted hubs have walls of this thickness; 0 is as thick as the bolts</source>
   <translation>Paroi du moyeu : épaisseur de paroi des moyeux boulonnés ; 0 : épaisse comme les boulons</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Isometric nets: faces keep the shape that this net has; empty: as it starts</source>
   <translation>Réseaux isométriques : les faces gardent la forme qu'a ce réseau ; vide : comme il commence</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>It is asked of the diagonals of the faces, not of the edges</source>
   <translation>On le demande aux diagonales des faces, pas aux arêtes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>K factor: folds keep the length of the fibre at this part of the thickness, 0: by DIN 6935</source>
   <translation>Facteur k : les plis gardent la longueur de la fibre à cette part de l'épaisseur ; 0 : selon DIN 6935</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Keep the last line where the step misses it</source>
   <translation>Garder la dernière ligne là où le pas la manque</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kerf: outlines grow by half this width of a cut</source>
   <translation>Trait de coupe : les contours croissent de la moitié du trait de coupe</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Largest displacement that passes</source>
   <translation>Plus grand déplacement admis</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Largest share of the strain energy that is not of axial forces, %</source>
   <translation>Plus grande part de l'énergie de déformation non due aux efforts normaux, %</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Layers: one layer has slots where strips cross, two have bolt holes</source>
   <translation>Couches : une couche a des encoches où les bandes se croisent, deux ont des trous de boulons</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Least factor on the loads; 0 where nothing buckles</source>
   <translation>Plus petit facteur sur les charges ; 0 si rien ne flambe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least length: beams that are shorter than this at the border are left out</source>
   <translation>Longueur minimale : les poutres plus courtes au bord sont laissées de côté</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least width: pieces of panels at the border that are narrower than this are slivers</source>
   <translation>Largeur minimale : les morceaux de panneaux plus étroits au bord sont des chutes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>Length on the page of a length of one</source>
   <translation>Longueur sur la page d'une longueur de un</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Lengths, curvatures, angles: range from the values</source>
   <translation>Longueurs, courbures, angles : plage d'après les valeurs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Less than 1 moves the centre farther away</source>
   <translation>Moins de 1 éloigne le centre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Lines as 'strength: 1.35 self-weight + 1.5 snow'; empty: those of EN 1990</source>
   <translation>Lignes comme 'strength: 1.35 self-weight + 1.5 snow' ; vide : celles de l'EN 1990</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines stand at even distances, or at equal steps of the parameters</source>
   <translation>Les lignes sont à distances égales ou à pas égaux des paramètres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u and v lie in two layers, u above, the middles of their sections this far apart</source>
   <translation>Les lignes u et v sont en deux couches, u au-dessus, les milieux de leurs sections à cette distance</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u, lines v and diagonals of a web are these: a asymptotic, g geodesic</source>
   <translation>Lignes u, lignes v et diagonales d'un tissu sont : a asymptotiques, g géodésiques</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>Load case of the structural check</source>
   <translation>Cas de charge de la vérification statique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Louvre axis: the louvres turn about lines of this family</source>
   <translation>Axe des brise-soleil : les brise-soleil tournent autour des lignes de cette famille</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Make the net anew when its source changes; off once its vertices were moved</source>
   <translation>Refaire le réseau quand sa source change ; désactivé dès que ses sommets ont bougé</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Mark inner vertices with more or fewer than four edges</source>
   <translation>Marquer les sommets intérieurs qui n'ont pas quatre arêtes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Mark the supported vertices, those of the boundary</source>
   <translation>Marquer les sommets appuyés, ceux du bord</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Mass of all members, kg</source>
   <translation>Masse de toutes les barres, kg</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Material of all parts</source>
   <translation>Matériau de toutes les pièces</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Members buckle in so many times their length</source>
   <translation>Les barres flambent sur tant de fois leur longueur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Mirror planes through the origin: letters of x, y, z</source>
   <translation>Plans de symétrie par l'origine : lettres parmi x, y, z</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it bends lines more evenly on the way; none is usual; -1 is automatic</source>
   <translation>Plus il y en a, plus les lignes se courbent régulièrement en chemin ; d'habitude aucun; -1 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it draws lines straighter on the way; 0.01 is usual; -1 is automatic</source>
   <translation>Plus il y en a, plus les lignes sont tirées droites en chemin ; d'habitude 0,01; -1 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps direction and length of edges; 0.02 is usual; -1 is automatic</source>
   <translation>Plus il y en a, plus les arêtes gardent direction et longueur ; d'habitude 0,02; -1 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps pairs of faces orthogonal; 0.001 is usual; -1 is automatic</source>
   <translation>Plus il y en a, plus les paires de faces restent orthogonales ; d'habitude 0,001; -1 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps vertices nearer to where they are; 0.003 is usual; -1 is automatic</source>
   <translation>Plus il y en a, plus les sommets restent près de leur place ; d'habitude 0,003; -1 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it moves neighbours more alike; 0.1 is usual; -1 is automatic</source>
   <translation>Plus il y en a, plus les voisins se déplacent de même ; d'habitude 0,1; -1 : automatique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Movements of nodes, then middles of members; modes one after the other</source>
   <translation>Mouvements des nœuds, puis des milieux de barres ; modes l'un après l'autre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>N, Vy, Vz, T, My, Mz at start, middle and end of the members, kN, kNm</source>
   <translation>N, Vy, Vz, T, My, Mz au début, au milieu et à la fin des barres, kN, kNm</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Names of the parts that do not fit on a sheet</source>
   <translation>Noms des pièces qui ne tiennent sur aucune tôle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Names of the parts, in the order of the shape</source>
   <translation>Noms des pièces, dans l'ordre de la forme</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Names of the parts, in the order of the solids</source>
   <translation>Noms des pièces, dans l'ordre des solides</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Net that the structure is built on</source>
   <translation>Réseau sur lequel la structure est construite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Net whose edges are the members</source>
   <translation>Réseau dont les arêtes sont les barres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Nets that this one is made of</source>
   <translation>Réseaux dont celui-ci est fait</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>New vertices lie in the middle, or all are smoothed</source>
   <translation>Les nouveaux sommets sont au milieu, ou tous sont lissés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>No boundary beams: no beams are made along the boundary</source>
   <translation>Sans poutres de bord : aucune poutre n'est faite le long du bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Node: the beams are joined by hubs or sockets</source>
   <translation>Nœud : les poutres sont reliées par des moyeux ou des douilles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Nodes of the frame</source>
   <translation>Nœuds de l'ossature</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Nodes of the members, two each</source>
   <translation>Nœuds des barres, deux chacune</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Nodes whose hubs the panels stay clear of</source>
   <translation>Nœuds dont les panneaux évitent les moyeux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Number of sheets</source>
   <translation>Nombre de tôles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Number of the most used member: that of its edge</source>
   <translation>Numéro de la barre la plus sollicitée : celui de son arête</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>Number of the sheet that is shown; 0: all there is</source>
   <translation>Numéro de la tôle montrée ; 0 : tout ce qu'il y a</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Numbers of further vertices that do not move</source>
   <translation>Numéros d'autres sommets qui ne bougent pas</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Numbers of these parameter lines; empty: all</source>
   <translation>Numéros de ces lignes paramétriques ; vide : toutes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Numbers of vertices that are drawn to a place</source>
   <translation>Numéros de sommets attirés vers un lieu</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of a node in service</source>
   <translation>D'un nœud en service</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the modes under the loads that buckle it first</source>
   <translation>Des modes sous les charges qui la font flamber d'abord</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the most used member, %; 100 is all that it has</source>
   <translation>De la barre la plus sollicitée, % ; 100 est tout ce qu'elle a</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the nodes in all combinations, one by one</source>
   <translation>Des nœuds dans toutes les combinaisons, l'une après l'autre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Of the nodes, in the service case that moves one most</source>
   <translation>Des nœuds, dans le cas de service qui en déplace un le plus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Offset: the parts lie above the net, about it or below it</source>
   <translation>Décalage : les pièces se trouvent au-dessus du réseau, autour de lui ou en dessous</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/structure_view.py" />
   <source>One colour for all parts, or green and red by their verdicts</source>
   <translation>Une couleur pour toutes les pièces, ou vert et rouge selon leur verdict</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>One turn rises by this</source>
   <translation>Un tour monte d'autant</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Optimise again at once, as before, when the source of a net that was moved changes</source>
   <translation>Optimiser aussitôt de nouveau, comme avant, quand la source d'un réseau déplacé change</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Other than four lines meet here: auto for the fewest that the surface needs, none, or a file of rows x y z and 3, 5 or 6 lines</source>
   <translation>Ici se rencontrent plus ou moins de quatre lignes : auto pour le moins que la surface demande, none pour aucune, ou un fichier de lignes x y z et 3, 5 ou 6</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Overhang: the strips go this far beyond their last vertex, by default half their width; 0 is automatic</source>
   <translation>Débord : les bandes dépassent d'autant leur dernier sommet, par défaut de la moitié de leur largeur ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel edge: the sides of the panels are square, or bevelled along the beams</source>
   <translation>Chant des panneaux : les chants des panneaux sont d'équerre, ou biseautés le long des poutres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel thickness: the panels are this thick, by default as thick as the plates; 0 is automatic</source>
   <translation>Épaisseur des panneaux : les panneaux ont cette épaisseur, par défaut celle des plats ; 0 : automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels and lengths of edges may be this far from the shape of their kind; 0 is 1/1000 of an edge</source>
   <translation>Panneaux et longueurs d'arêtes peuvent s'écarter d'autant de la forme de leur type ; 0 : 1/1000 d'arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels weigh this much by their surface, kN/m2</source>
   <translation>Les panneaux pèsent autant par surface, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels with what holds them have this shear stiffness G t, kN/mm; with 0 they are load only</source>
   <translation>Les panneaux avec ce qui les tient ont cette rigidité de cisaillement G t, kN/mm ; avec 0 ils ne sont que charge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Parameter lines that are built on: u, v or both</source>
   <translation>Lignes paramétriques sur lesquelles on construit : u, v ou les deux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Part of the sheets that is left over, 0 to 1</source>
   <translation>Part des tôles qui reste, 0 à 1</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts pass that are off a plane or developable by this at most; 0: any</source>
   <translation>Les pièces qui s'écartent d'autant au plus d'un plan ou d'une développable passent ; 0 : toutes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts pass that lean from the surface normal by this at most; 0: any</source>
   <translation>Les pièces qui s'inclinent d'autant au plus de la normale passent ; 0 : toutes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pattern: the axes unroll to lines of this kind</source>
   <translation>Développé : les axes se déroulent en lignes de ce type</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Piece length: rows are cut along lines of the net into pieces of at most this length; 0 is whole rows</source>
   <translation>Longueur des pièces: les rangées sont coupées aux lignes du réseau en pièces de cette longueur au plus ; 0 : rangées entières</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Places that the handles are drawn to, in mm</source>
   <translation>Lieux vers lesquels les poignées sont attirées, en mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Planar nets: the diagonals of a face are this far apart at most; 0 is exactly flat</source>
   <translation>Réseaux plans : les diagonales d'une face sont distantes d'autant au plus ; 0 : exactement plan</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Points of closed curves along which parts are trimmed, in mm</source>
   <translation>Points de courbes fermées le long desquelles les pièces sont coupées, en mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Position: the strips stand on the surface, lie in it, or tilt as the net wants it</source>
   <translation>Position: les bandes sont debout sur la surface, couchées, ou inclinées comme le veut le réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Positions of the vertices, in mm</source>
   <translation>Positions des sommets, en mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post diameter: the posts are round tubes of this diameter</source>
   <translation>Diamètre de poteau : les poteaux sont des tubes ronds de ce diamètre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post wall: the walls of the posts are this thick</source>
   <translation>Paroi de poteau : épaisseur des parois des poteaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Quads that the border cuts are set onto it, or left out</source>
   <translation>Les quads que le bord coupe sont mis dessus ou laissés de côté</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Quantity that colours the net, explained by the scale in the view</source>
   <translation>Grandeur qui colore le réseau, expliquée par l'échelle dans la vue</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Red at and above this value (mm, 1/m, 1/m2, degrees) if not automatic</source>
   <translation>Rouge à cette valeur et au-dessus (mm, 1/m, 1/m2, degrés) si non automatique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Report of the last optimisation, as JSON</source>
   <translation>Rapport de la dernière optimisation, en JSON</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Residuals up to this count as zero</source>
   <translation>Les résidus jusqu'à cette valeur comptent pour zéro</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Residuals: blue at and below 10 to this power</source>
   <translation>Résidus : bleu à 10 à cette puissance et en dessous</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Residuals: red at and above 10 to this power</source>
   <translation>Résidus : rouge à 10 à cette puissance et au-dessus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rounded: solids have the rounded corners and roots of a section of the catalogue</source>
   <translation>Arrondi : les solides ont les coins et congés arrondis d'une section du catalogue</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Saw: a saw cut behind a piece is this wide</source>
   <translation>Trait de scie : un trait de scie après une pièce a cette largeur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Section and material checked</source>
   <translation>Section et matériau vérifiés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section width: hollow sections and flanges are this wide</source>
   <translation>Largeur de la section : les profils creux et les semelles ont cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section: the beams have this cross section, or one of the catalogue such as HEB160</source>
   <translation>Section : les poutres ont cette section, ou une du catalogue comme HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sections stand as those of beams do, or as lamellas of plate:THICKNESSxWIDTH: standing, lying or tilted as the net wants it</source>
   <translation>Les sections se tiennent comme celles de poutres, ou en lamelles plate:ÉPAISSEURxLARGEUR : debout, couchées ou inclinées comme le réseau le demande</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Shape that is drawn: the frame, or how it moves</source>
   <translation>Forme dessinée : l'ossature, ou comment elle bouge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet: parts are nested on sheets of this size</source>
   <translation>Plaque : les pièces sont imbriquées sur des plaques de cette taille</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show an arrow on the side that is up</source>
   <translation>Montrer une flèche sur le côté qui est en haut</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show both diagonals of each face</source>
   <translation>Montrer les deux diagonales de chaque face</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show reflection lines instead of colours</source>
   <translation>Montrer des lignes de réflexion au lieu de couleurs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show spheres through some of the vertex stars</source>
   <translation>Montrer des sphères par certaines étoiles de sommets</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the colour scale in the 3D view</source>
   <translation>Montrer l'échelle de couleurs dans la vue 3D</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the forces in the edges under equal loads, red for tension</source>
   <translation>Montrer les forces dans les arêtes sous charges égales, rouge pour la traction</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the lines between the midpoints of opposite edges</source>
   <translation>Montrer les lignes entre les milieux d'arêtes opposées</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the load of each free vertex</source>
   <translation>Montrer la charge de chaque sommet libre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/flat_patterns_view.py" />
   <source>Show the names of the parts</source>
   <translation>Montrer les noms des pièces</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the normals of the faces on a sphere beside the net</source>
   <translation>Montrer les normales des faces sur une sphère à côté du réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the parameter lines u and v in two colours</source>
   <translation>Montrer les lignes paramétriques u et v en deux couleurs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the rulings of strips along the parameter lines</source>
   <translation>Montrer les génératrices des bandes le long des lignes paramétriques</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Show the scale of the colours</source>
   <translation>Montrer l'échelle des couleurs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Show the torsion-free axes at the vertices</source>
   <translation>Montrer les axes sans torsion aux sommets</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slivers: slivers at the border become part of their neighbours where they can, or are left out</source>
   <translation>Chutes : les chutes au bord rejoignent leurs voisines si possible, ou sont omises</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slots leave this part of the height of lamellas that cross in one layer; with 1 there are none</source>
   <translation>Les entailles laissent cette part de la hauteur des lamelles qui se croisent en une couche ; avec 1 il n'y en a pas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Smooth: the solids are smooth instead of faceted</source>
   <translation>Lisse : les solides sont lisses au lieu de facettés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow also lies on one half, as a case of its own: the half towards this direction</source>
   <translation>La neige est aussi sur une moitié, comme un cas à part : celle dans cette direction</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow weighs this much by the plan, kN/m2</source>
   <translation>La neige pèse autant en plan, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>So many mm are drawn for a kN or kNm of the diagram; 0: as it fits</source>
   <translation>Tant de mm sont tracés pour un kN ou kNm du diagramme ; 0 : comme cela tient</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many modes of buckling are found</source>
   <translation>Autant de modes de flambement sont cherchés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rings of faces are cut off at the border</source>
   <translation>Tant d'anneaux de faces sont coupés au bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rows are cut off at the starts and ends of u and v</source>
   <translation>Tant de rangées sont coupées aux débuts et aux fins de u et v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many times four faces are made of one</source>
   <translation>Tant de fois quatre faces sont faites d'une</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many vertices stand along u and along v</source>
   <translation>Il y a tant de sommets selon u et selon v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Socket depth: the plates stand this deep in the sockets</source>
   <translation>Profondeur des douilles : les plats entrent de cette profondeur dans les douilles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Splice every: spliced beams have a splice after so many nodes, 0 for none</source>
   <translation>Joint tous les: les poutres éclissées ont un joint après autant de nœuds, 0 pour aucun</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>Stands for all that the shape was built from</source>
   <translation>Représente tout ce dont la forme a été construite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>Stands for the net as its source made it last</source>
   <translation>Représente le réseau tel que sa source l'a fait en dernier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stock: strips are cut from this length; longer ones are spliced; 0 is as long as it takes</source>
   <translation>Longueur en stock : les bandes sont coupées dans cette longueur ; les plus longues sont éclissées ; 0 : aussi longue qu'il faut</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a millimetre of edge has this weight</source>
   <translation>Réseaux de contraintes : un millimètre d'arête a ce poids</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a square millimetre carries this load, downwards</source>
   <translation>Réseaux de contraintes : un millimètre carré porte cette charge, vers le bas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: edges may carry these forces</source>
   <translation>Réseaux de contraintes : les arêtes peuvent porter ces forces</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: every vertex carries this load, downwards</source>
   <translation>Réseaux de contraintes : chaque sommet porte cette charge, vers le bas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: the shell whose stresses the lines follow stands on this</source>
   <translation>Réseaux de contraintes : la coque dont les lignes suivent les contraintes repose sur ceci</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: this carries the loads: boundary, which slides along its own curve but for its corners; corners or vertices such as 0,5,12, which stay; empty: as the net needs</source>
   <translation>Réseaux de contraintes : ceci porte les charges : boundary, le bord, qui glisse le long de sa propre courbe sauf en ses coins ; corners ou des sommets comme 0,5,12, qui restent ; vide : ce que le réseau demande</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strip: the strips are made of plane faces or twisted</source>
   <translation>Bande : les bandes sont faites de faces planes ou tordues</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along u have this angle to the surface: 90 stands, 180 lies; 0 is free</source>
   <translation>Les bandes selon u ont cet angle avec la surface : 90 debout, 180 couchées ; 0 : libre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along v have this angle to the surface: 90 stands, 180 lies; 0 is free</source>
   <translation>Les bandes selon v ont cet angle avec la surface : 90 debout, 180 couchées ; 0 : libre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>Structure whose weight is a load by the surface, such as panels</source>
   <translation>Structure dont le poids est une charge de surface, comme des panneaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Structures whose parts are shown</source>
   <translation>Structures dont les pièces sont montrées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along x rises by this, or hangs where it is negative</source>
   <translation>L'arc selon x monte d'autant, ou pend si c'est négatif</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along y rises by this, or hangs where it is negative</source>
   <translation>L'arc selon y monte d'autant, ou pend si c'est négatif</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The border is left a zigzag, or closed by narrow quads</source>
   <translation>Le bord reste en zigzag, ou est fermé par des quads étroits</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The cables have this force density, force / length</source>
   <translation>Les câbles ont cette densité de force, force / longueur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>The check as JSON</source>
   <translation>La vérification en JSON</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The curve goes through these points instead, about the centre</source>
   <translation>La courbe passe plutôt par ces points, autour du centre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The edges carry this load, force / mm</source>
   <translation>Les arêtes portent cette charge, force / mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The ends of a curve that is no preset are joined</source>
   <translation>Les extrémités d'une courbe qui n'est pas prédéfinie sont jointes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this load, force / mm2</source>
   <translation>Les faces portent cette charge, force / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this pressure along their normals, force / mm2</source>
   <translation>Les faces portent cette pression selon leurs normales, force / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The families u and v change places</source>
   <translation>Les familles u et v échangent leurs places</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of the two holds the first vertex</source>
   <translation>Le premier des deux contient le premier sommet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of them follows this formula of s</source>
   <translation>La première suit cette formule de s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix has this radius</source>
   <translation>L'hélice a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix turns by this angle</source>
   <translation>L'hélice tourne de cet angle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The imperfection is this large; 0 is 1/300 of the second longest side of the box</source>
   <translation>L'imperfection a cette grandeur ; 0 : 1/300 du deuxième plus long côté de la boîte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The inversion has its centre here</source>
   <translation>L'inversion a son centre ici</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The largest displacement that passes is this part of the second longest side of the net's box: 200 for 1/200</source>
   <translation>Le plus grand déplacement admis est cette part du deuxième plus long côté de la boîte du réseau : 200 pour 1/200</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The last point is joined with the first</source>
   <translation>Le dernier point est joint au premier</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>The loads count so many times; 0 leaves them out</source>
   <translation>Les charges comptent autant de fois ; 0 les omet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The lower end has this radius</source>
   <translation>L'extrémité basse a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members are made of this</source>
   <translation>Les barres sont faites de ceci</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members have this profile; groups another one after it, as tube:100x60x5,border=tube:120x60x5</source>
   <translation>Les barres ont ce profil ; des groupes un autre à la suite, comme tube:100x60x5,border=tube:120x60x5</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane has this stress, force / length</source>
   <translation>La membrane a cette contrainte, force / longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane's border cable has this force</source>
   <translation>Le câble de bord de la membrane a cette force</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The middle of sections lies this far above the net, along its axes</source>
   <translation>Le milieu des sections est à cette distance au-dessus du réseau, selon ses axes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror image comes alone</source>
   <translation>L'image miroir vient seule</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane goes through this point</source>
   <translation>Le plan de symétrie passe par ce point</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane has this normal</source>
   <translation>Le plan de symétrie a cette normale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The multi-net guide keeps patches of so many faces along and across orthogonal</source>
   <translation>Le guide multi-réseau garde orthogonaux des morceaux de tant de faces en long et en travers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The narrowest circle has this radius</source>
   <translation>Le cercle le plus étroit a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of u</source>
   <translation>Le réseau couvre cette part de l'étendue de u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of v</source>
   <translation>Le réseau couvre cette part de l'étendue de v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net follows these lines of the surface</source>
   <translation>Le réseau suit ces lignes de la surface</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these angles about the axis</source>
   <translation>Le réseau va du premier au second de ces angles autour de l'axe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these latitudes</source>
   <translation>Le réseau va de la première à la seconde de ces latitudes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t of the confocal family</source>
   <translation>Le réseau va du premier au second t de la famille confocale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t; with 0 and 0 it keeps clear of both ends</source>
   <translation>Le réseau va du premier au second t ; avec 0 et 0 il reste à l'écart des deux bouts</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes on along these axes as its mirror image, as x,y</source>
   <translation>Le réseau continue le long de ces axes comme son image en miroir, comme x,y</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is its own mirror image in these planes: auto for those that the surface has, or those across an axis, through the middle of the surface</source>
   <translation>Le réseau est sa propre image en miroir dans ces plans : auto pour ceux de la surface, ou ceux perpendiculaires à un axe, par le milieu de la surface</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is made of cables, or is a membrane of one stress</source>
   <translation>Le réseau est fait de câbles, ou est une membrane de contrainte égale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is moved by this</source>
   <translation>Le réseau est déplacé de ceci</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is scaled by this factor</source>
   <translation>Le réseau est mis à l'échelle par ce facteur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this long along x</source>
   <translation>Le réseau a cette longueur selon x</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this wide across</source>
   <translation>Le réseau a cette largeur en travers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is to become this one; asymptotic and cmc lines run at 45 degrees to curvature, those of asymptotic-angle where the surface does not bend, stress lines as a shell carries its weight</source>
   <translation>Le réseau doit devenir celui-ci ; les lignes asymptotiques et cmc vont à 45 degrés de la courbure, celles de asymptotic-angle là où la surface ne se courbe pas, celles de contraintes comme une coque porte son poids</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is turned by these angles about x, then y, then z</source>
   <translation>Le réseau est tourné de ces angles autour de x, puis y, puis z</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches so far over the surface, farther where this is larger</source>
   <translation>Le réseau s'étend d'autant sur la surface, plus loin si c'est plus grand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches this far from the axis on both sides</source>
   <translation>Le réseau s'étend d'autant de part et d'autre de l'axe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net runs along these lines, drawn on the surface</source>
   <translation>Le réseau suit ces lignes dessinées sur la surface</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net stands here, turned like this</source>
   <translation>Le réseau est ici, tourné ainsi</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>The net that optimising and editing aim at</source>
   <translation>Le réseau visé par l'optimisation et l'édition</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The offset lies this far along the normals, below where it is negative</source>
   <translation>Le décalage est à cette distance selon les normales, au-dessous si elle est négative</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The other side is turned up</source>
   <translation>L'autre côté est tourné vers le haut</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>The other side is up than where the net came from</source>
   <translation>L'autre côté est en haut que là d'où vient le réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline goes through these points, in the frame of the quadric</source>
   <translation>La ligne brisée passe par ces points, dans le repère de la quadrique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline lies on this quadric</source>
   <translation>La ligne brisée est sur cette quadrique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The result may be this far off the surface, or the start where none is given; 0 is not limited</source>
   <translation>Le résultat peut s'écarter d'autant de la surface, ou du départ si aucune n'est donnée ; 0 : sans limite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The second of them follows this formula of s</source>
   <translation>La seconde suit cette formule de s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes are this long, the largest comes first</source>
   <translation>Les demi-axes ont ces longueurs, le plus grand vient d'abord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of lambda = 0 are this long, the largest comes first</source>
   <translation>Les demi-axes de lambda = 0 ont ces longueurs, le plus grand vient d'abord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of the quadric are this long</source>
   <translation>Les demi-axes de la quadrique ont ces longueurs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>The shape waits to be built anew</source>
   <translation>La forme attend d'être reconstruite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>The source has changed since the vertices were moved; optimise again</source>
   <translation>La source a changé depuis que les sommets ont bougé ; optimiser à nouveau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has its centre here</source>
   <translation>La sphère a son centre ici</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has this radius</source>
   <translation>La sphère a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface grows in proportion to this length</source>
   <translation>La surface grandit en proportion de cette longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has so many waves along its axis</source>
   <translation>La surface a tant d'ondes le long de son axe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has this radius</source>
   <translation>La surface a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface is this high</source>
   <translation>La surface a cette hauteur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The tangents of these points make the sheet; empty for a helix</source>
   <translation>Les tangentes en ces points font la surface ; vide pour une hélice</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two directions meet at this angle; 0 is as the net has it</source>
   <translation>Les deux directions se rencontrent sous cet angle ; 0 : selon le réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates follow this curve</source>
   <translation>Les deux autres coordonnées suivent cette courbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates have these values instead</source>
   <translation>Les deux autres coordonnées ont plutôt ces valeurs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The upper end has this radius</source>
   <translation>L'extrémité haute a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The weight of the members is a load</source>
   <translation>Le poids des barres est une charge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The widest circle has this radius</source>
   <translation>Le cercle le plus large a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>The wind has this pressure in kN/m2 and blows this way, as 0.6@x; a case each</source>
   <translation>Le vent a cette pression en kN/m2 et souffle par là, comme 0.6@x ; un cas chacun</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>There may be so many kinds; 0 is as few as can be found</source>
   <translation>Il peut y avoir tant de types ; 0 : aussi peu que possible</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or numbers of vertices, each with :pinned, :fixed, :sliding (up and down only) or :springs=X/Y/Z (kN/mm), joined by +</source>
   <translation>Ceci est tenu : boundary, corners ou des numéros de sommets, chacun avec :pinned, :fixed, :sliding (de haut en bas seulement) ou :springs=X/Y/Z (kN/mm), joints par +</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or vertices as 0,5,12</source>
   <translation>Ceci est tenu : boundary, corners ou des sommets comme 0,5,12</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These lines lie in planes of their own</source>
   <translation>Ces lignes sont dans des plans à elles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These points (radius, height) are turned about z</source>
   <translation>Ces points (rayon, hauteur) sont tournés autour de z</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These supports are raised first, VERTEX:HEIGHT in mm as 0:1500; 20:900</source>
   <translation>Ces appuis sont d'abord levés, SOMMET:HAUTEUR en mm comme 0:1500; 20:900</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structural_check.py" />
   <source>These vertices carry these forces in kN, as 12:0,0,-5</source>
   <translation>Ces sommets portent ces forces en kN, comme 12:0,0,-5</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Thickness: the plates are this thick</source>
   <translation>Épaisseur : les plats ont cette épaisseur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This elliptic coordinate has the role of t</source>
   <translation>Cette coordonnée elliptique a le rôle de t</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This part of the range is left free at each end</source>
   <translation>Cette part de l'étendue reste libre à chaque bout</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This point stays where it is</source>
   <translation>Ce point reste où il est</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Through: plates of this family run through where two cross, both by half laps</source>
   <translation>Continue: les plaques de cette famille passent là où deux se croisent, les deux à mi-bois</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tilt: the louvres are turned by this angle about their lines</source>
   <translation>Inclinaison : les brise-soleil sont tournés de cet angle autour de leurs lignes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Trim: the stock loses this much at each end</source>
   <translation>Éboutage : la longueur en stock perd autant à chaque bout</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Unit of the file that the net came from</source>
   <translation>Unité du fichier d'où vient le réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Unrolled axes pass that are off straight by this at most; 0: any</source>
   <translation>Les axes déroulés qui s'écartent d'autant au plus d'une droite passent ; 0 : tous</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Unrolled axes pass that are off their arc by this at most; 0: any</source>
   <translation>Les axes déroulés qui s'écartent d'autant au plus de leur arc passent ; 0 : tous</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Utilisation of each member, 1 is all</source>
   <translation>Taux de travail de chaque barre, 1 est tout</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/properties.py" />
   <source>Version of this object's properties</source>
   <translation>Version des propriétés de cet objet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>Vertex numbers of the quads, four a face</source>
   <translation>Numéros des sommets des quadrilatères, quatre par face</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices that are nearer than this are merged</source>
   <translation>Les sommets plus proches que ceci sont fusionnés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Vertices that do not move</source>
   <translation>Sommets qui ne bougent pas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices, edges or faces keep the distance, or edges stay parallel</source>
   <translation>Sommets, arêtes ou faces gardent la distance, ou les arêtes restent parallèles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>What each part exceeds, 'ok' if nothing</source>
   <translation>Ce que chaque pièce dépasse, 'ok' si rien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>What is to be known about the net as it was made</source>
   <translation>Ce qu'il faut savoir du réseau tel qu'il a été fait</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>What is to be known before the shape is used</source>
   <translation>Ce qu'il faut savoir avant d'utiliser la forme</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>What is to be known of the model</source>
   <translation>Ce qu'il faut savoir du modèle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>What the check comes to, in one line</source>
   <translation>Ce que donne la vérification, en une ligne</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>What the colours of the members say</source>
   <translation>Ce que disent les couleurs des barres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>What the net is built with</source>
   <translation>Ce avec quoi le réseau est construit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>What the net is made by</source>
   <translation>Ce par quoi le réseau est fait</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/drawings.py" />
   <source>What the picture shows of them</source>
   <translation>Ce que l'image en montre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net.py" />
   <source>What was taken off the coordinates of a file far from the origin; export puts it back</source>
   <translation>Ce qui a été retiré des coordonnées d'un fichier loin de l'origine ; l'export le rajoute</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Where lines u and v cross, in slots of one layer or about the bolts of two, they turn like this about their axis: rigid, hinged, or the stiffness of a spring in kNm/rad</source>
   <translation>Là où les lignes u et v se croisent, dans les entailles d'une couche ou autour des boulons de deux, elles tournent ainsi autour de leur axe : rigid, hinged ou la raideur d'un ressort en kNm/rad</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Where the height of the members' sections points to</source>
   <translation>Direction de la hauteur des sections</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Where the names stand</source>
   <translation>Où sont les noms</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>Where the shape stands while nobody has moved it</source>
   <translation>Où se trouve la forme tant que personne ne l'a déplacée</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/check_results.py" />
   <source>Whether all that was checked holds</source>
   <translation>Si tout ce qui a été vérifié tient</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/net_settings.py" />
   <source>Which vertices glide on each: their numbers, empty for those near it</source>
   <translation>Quels sommets glissent sur chacune : leurs numéros, vide pour les proches</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/flat_patterns.py" />
   <source>Width of a sheet; 0: the parts lie in rows</source>
   <translation>Largeur d'une tôle ; 0 : les pièces sont en rangées</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/net_properties.py" />
   <source>Width of the edges in pixels</source>
   <translation>Largeur des arêtes en pixels</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Width of the members, in pixels</source>
   <translation>Largeur des barres, en pixels</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Width: the strips are this wide</source>
   <translation>Largeur : les bandes ont cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>another number begins another search for a dense nesting</source>
   <translation>un autre nombre commence une autre recherche d'imbrication dense</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>boxes pack fast, outlines densely</source>
   <translation>les boîtes rangent vite, les contours serré</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>outlines grow by half this width of a cut</source>
   <translation>les contours croissent de la moitié du trait de coupe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts keep so far from each other and from the rim</source>
   <translation>distance entre les pièces et jusqu'au bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts may turn on the sheet as its grain says</source>
   <translation>les pièces tournent sur la plaque selon le sens du fil</translation>
  </message>
 </context>
 <context>
  <name>Ortho</name>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>, drawn {:g} times</source>
   <translation>, dessinés {:g} fois</translation>
  </message>
  <message>
   <location filename="../../../solver/align/align.py" />
   <source>1 face is folded; give a shorter edge, or smooth the surface there</source>
   <translation>1 face est repliée ; donner une arête plus courte ou lisser la surface à cet endroit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>1 mm, slots by material</source>
   <translation>1 mm, entailles selon le matériau</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/mirror.py" />
   <source>1 vertex merged</source>
   <translation>1 sommet fusionné</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/aligning.py" />
   <source>1 vertex with {} lines</source>
   <translation>1 sommet à {} lignes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>1/1000 of an edge</source>
   <translation>1/1000 d'arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>1/300 of the second longest side of the box</source>
   <translation>1/300 du deuxième plus long côté de la boîte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>100 mm, of bolted ones what each needs</source>
   <translation>100 mm, boulonnés : selon le besoin</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>A click marks the worst place, a double click shows the measure in colours.</source>
   <translation>Un clic marque le pire endroit, un double clic montre la mesure en couleurs.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface of geodesic squares.</source>
   <translation>Une surface développable de carrés géodésiques.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface of squares, all edges equal.</source>
   <translation>Une surface développable de carrés, toutes arêtes égales.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface, by the stricter definition.</source>
   <translation>Une surface développable, selon la définition plus stricte.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A developable surface: it is bent from flat sheet.</source>
   <translation>Une surface développable : courbée d'une tôle plane.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>A list, or sections joined by +</source>
   <translation>Une liste, ou des sections reliées par +</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A membrane or cable net in equilibrium with its supports and loads</source>
   <translation>Une membrane ou un réseau de câbles en équilibre avec ses appuis et ses charges</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A minimal surface with straight upright lamellas.</source>
   <translation>Une surface minimale à lamelles droites et dressées.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A net along lines of curvature of CAD faces, or at 45 degrees to them</source>
   <translation>Un réseau le long des lignes de courbure de faces CAO, ou à 45 degrés de celles-ci</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>A net that came from far away lies about a point nearby, where CAD kernels keep their accuracy; its file's coordinates are put back on demand.</source>
   <translation>Un réseau venu de loin est placé autour d'un point proche, où les noyaux CAO gardent leur précision ; les coordonnées de son fichier sont rétablies sur demande.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>A parallel net at a distance that is constant where the net allows it</source>
   <translation>Un réseau parallèle à une distance constante là où le réseau le permet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Add</source>
   <translation>Ajouter</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Add points</source>
   <translation>Ajouter des points</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/advanced_box.py" />
   <source>Advanced</source>
   <translation>Avancé</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Alike to</source>
   <translation>Angles à</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Alike within</source>
   <translation>Égaux à</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>All parts are made of this.</source>
   <translation>Toutes les pièces sont faites de ceci.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Along</source>
   <translation>Le long de</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Also write</source>
   <translation>Écrire aussi</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Analysis added; the FEM workbench solves it</source>
   <translation>Analyse ajoutée ; l'atelier FEM la résout</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Analysis of the FEM workbench</source>
   <translation>Analyse de l'atelier FEM</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Anchor</source>
   <translation>Ancrage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Angle</source>
   <translation>Angle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Angles</source>
   <translation>Angles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Area load</source>
   <translation>Charge surfacique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Arms</source>
   <translation>Bras</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Arms beside the net</source>
   <translation>Bras à côté du réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Arrow on the upper side</source>
   <translation>Flèche sur le dessus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Asked</source>
   <translation>Demandé</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Assemblies in IFC</source>
   <translation>Ensembles dans IFC</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Assembly</source>
   <translation>Montage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Asymptotic</source>
   <translation>Asymptotique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Asymptotic diagonals</source>
   <translation>Diagonales asymptotiques</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>At</source>
   <translation>À</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At hubs</source>
   <translation>Aux moyeux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the larger one</source>
   <translation>En son sommet la surface a ce rayon de courbure, le plus grand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At its vertex the surface has this radius of curvature, the smaller one</source>
   <translation>En son sommet la surface a ce rayon de courbure, le plus petit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At the border</source>
   <translation>Au bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>At the border the net overhangs the surface, to be trimmed, or bends to follow it</source>
   <translation>Au bord, le réseau dépasse la surface, pour être coupé, ou se plie pour le suivre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Axial force</source>
   <translation>Effort normal</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Axial forces</source>
   <translation>Efforts normaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>BTLx says how parts of timber are cut, drilled and marked</source>
   <translation>BTLx dit comment les pièces de bois sont coupées, percées et marquées</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>Bake</source>
   <translation>Figer</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Balance is found in the deformed, imperfect shape</source>
   <translation>L'équilibre est trouvé dans la forme déformée et imparfaite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Begin a new polyline: click its points on the quadric.</source>
   <translation>Commencer une polyligne : cliquer ses points sur la quadrique.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bend radius</source>
   <translation>Rayon de pliage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bending</source>
   <translation>Cintrage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bending radius</source>
   <translation>Rayon de courbure</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bent so that circles stay circles; place and size stay</source>
   <translation>Courbé de sorte que les cercles restent des cercles ; lieu et taille restent</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Beside what it is off right angles, which all these nets ask for.</source>
   <translation>Sans compter l'écart aux angles droits, que tous ces réseaux demandent.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bite</source>
   <translation>Largeur de joint</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolt</source>
   <translation>Boulon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bolts</source>
   <translation>Boulons</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border</source>
   <translation>Bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cables have this force density; 0 is the same</source>
   <translation>Les câbles de bord ont cette densité de force ; 0 : la même</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border cut</source>
   <translation>Coupe au bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border density</source>
   <translation>Densité du bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Border force</source>
   <translation>Force du bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Bore</source>
   <translation>Alésage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Buckling length</source>
   <translation>Flambement</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Buckling shape {}</source>
   <translation>Mode de flambement {}</translation>
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
   <translation>Faces CAO échantillonnées le long de leurs propres lignes paramétriques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC</source>
   <translation>CMC</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC diagonals</source>
   <translation>CMC, diagonales</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>CMC nets: the vertex spheres have this radius</source>
   <translation>Réseaux CMC : les sphères des sommets ont ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Catenoid around z, from -height / 2 to height / 2.</source>
   <translation>Caténoïde autour de z, de -hauteur / 2 à hauteur / 2.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Centre</source>
   <translation>Centre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/sources.py" />
   <source>Change source</source>
   <translation>Modifier la source</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/common.py" />
   <source>Change {}</source>
   <translation>Modifier {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev</source>
   <translation>Tchebychev</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev diagonals</source>
   <translation>Tchebychev diag.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: each direction has a length of its own</source>
   <translation>Réseaux de Tchebychev : chaque direction a sa propre longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev nets: the edges are this long</source>
   <translation>Réseaux de Tchebychev : les arêtes ont cette longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Chebyshev: equal edges</source>
   <translation>Tchebychev : arêtes égales</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Check</source>
   <translation>Vérifier</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>Choose the recommended net.</source>
   <translation>Choisir le réseau recommandé.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Christoffel dual</source>
   <translation>dual de Christoffel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular</source>
   <translation>Circulaire</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular arch moved along another one; negative rises hang.</source>
   <translation>Arc de cercle déplacé le long d'un autre ; les flèches négatives pendent.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular cone around z, cut off at the top, rulings along v; isosceles trapezoids.</source>
   <translation>Cône circulaire autour de z, tronqué en haut, génératrices selon v ; trapèzes isocèles.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Circular cylinder around z, rulings along v; faces are rectangles.</source>
   <translation>Cylindre circulaire autour de z, génératrices selon v ; les faces sont des rectangles.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clear</source>
   <translation>Effacer</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clear distance</source>
   <translation>Distance libre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Clearance</source>
   <translation>Jeu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cleats</source>
   <translation>Équerres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>Click edges in the 3D view, or wires and sketches in the tree, that lines of the net run along; a second click leaves them out.</source>
   <translation>Cliquez des arêtes dans la vue 3D, ou des fils et esquisses dans l'arbre, le long desquels courent des lignes du réseau ; un second clic les retire.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click edges, faces or planes that the boundary near them (on a curved face: every vertex) glides on, exactly.</source>
   <translation>Cliquer arêtes, faces ou plans sur lesquels le bord proche (sur une face courbe : chaque sommet) glisse exactement.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click faces that the net stays near as far as it can.</source>
   <translation>Cliquer les faces dont le réseau reste proche autant que possible.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Click points on the quadric; right click or Esc ends.</source>
   <translation>Cliquer des points sur la quadrique ; clic droit ou Échap termine.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/form_panel.py" />
   <source>Click vertices in the 3D view to hold them; click again to free.</source>
   <translation>Cliquer des sommets dans la vue 3D pour les tenir ; cliquer à nouveau pour les libérer.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click vertices that are held softly, or drag them to a place.</source>
   <translation>Cliquer les sommets tenus souplement, ou les tirer vers un lieu.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Click vertices that must not move; a second click frees them.</source>
   <translation>Cliquer les sommets qui ne doivent pas bouger ; un second clic les libère.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Clicks add points at the end; Backspace takes the last one away.</source>
   <translation>Les clics ajoutent des points à la fin ; Retour arrière enlève le dernier.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Close</source>
   <translation>Fermer</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Close the open task panel first.</source>
   <translation>Fermez d'abord le panneau de tâches ouvert.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Closed</source>
   <translation>Fermé</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Closeness</source>
   <translation>Proximité</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Colour map</source>
   <translation>Carte de couleurs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Confocal ellipses x^2/(a + t) + y^2/(b + t) = 1 and their hyperbolas, flat; a multi-net.</source>
   <translation>Ellipses homofocales x^2/(a + t) + y^2/(b + t) = 1 et leurs hyperboles, planes ; un multi-réseau.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Conical</source>
   <translation>Conique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Constant mean curvature; lamellas unroll to equal arcs.</source>
   <translation>Courbure moyenne constante ; les lamelles se déroulent en arcs égaux.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Constraints</source>
   <translation>Contraintes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Coordinates</source>
   <translation>Coordonnées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Corner</source>
   <translation>Coin</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cross rise</source>
   <translation>Flèche transversale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Crossings</source>
   <translation>Croisements</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Curvature lines of an ellipsoid around its longest axis, closed in u.</source>
   <translation>Lignes de courbure d'un ellipsoïde autour de son plus grand axe, fermées en u.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Curvature lines of z = x^2 / (2 first) + y^2 / (2 second) over the quarter x, y &gt; 0.</source>
   <translation>Lignes de courbure de z = x^2 / (2 premier) + y^2 / (2 second) sur le quart x, y &gt; 0.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Curve</source>
   <translation>Courbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Cutter</source>
   <translation>Fraise</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>DXF drawings</source>
   <translation>Dessins DXF</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>DXF version</source>
   <translation>Version DXF</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Date</source>
   <translation>Date</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Deflected shape</source>
   <translation>Forme déformée</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Deflection</source>
   <translation>Flèche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Density</source>
   <translation>Densité</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Diagonals</source>
   <translation>Diagonales</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Displacement</source>
   <translation>Déplacement</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/display.py" />
   <source>Display</source>
   <translation>Affichage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Distance</source>
   <translation>Distance</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Distortion</source>
   <translation>Distorsion</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Drag</source>
   <translation>Tirer</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Drag a vertex. Click: choose; Ctrl: several; Shift and drag: all in a frame; Del: no handle any more; Esc: put back. Handles that are not dragged stay exactly where they are. Each drag is one step for Undo.</source>
   <translation>Tirer un sommet. Clic : choisir ; Ctrl : plusieurs ; Maj et tirer : tous dans un cadre ; Suppr : plus de poignée ; Échap : remettre. Les poignées qui ne sont pas tirées restent exactement où elles sont. Chaque tirage est un pas pour Annuler.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Drag the points along the surface; dropped onto each other, one with 3 and one with 5 lines vanish, and two with 5 become one with 6</source>
   <translation>Glissez les points sur la surface ; posés l'un sur l'autre, un à 3 et un à 5 lignes disparaissent, et deux à 5 en font un à 6</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Drag vertices</source>
   <translation>Tirer des sommets</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>Draw</source>
   <translation>Dessiner</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>Drawing page</source>
   <translation>Page de dessin</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>Drawing pages</source>
   <translation>Pages de dessin</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Drawings</source>
   <translation>Dessins</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Drawn strokes</source>
   <translation>Courbes dessinées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Dual ratio</source>
   <translation>Rapport dual</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Each vertex carries this load, a force along x, y and z</source>
   <translation>Chaque sommet porte cette charge, une force selon x, y et z</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Each vertex lies on one sphere with its neighbours.</source>
   <translation>Chaque sommet est sur une sphère avec ses voisins.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Eccentric</source>
   <translation>Excentré</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge</source>
   <translation>Arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge cover</source>
   <translation>Recouvrement</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge height</source>
   <translation>Hauteur de rive</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge length</source>
   <translation>Longueur d'arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge load</source>
   <translation>Charge d'arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge section</source>
   <translation>Profil de rive</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge vectors</source>
   <translation>Vecteurs d'arêtes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge wall</source>
   <translation>Paroi du tube</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edge width</source>
   <translation>Largeur de rive</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges</source>
   <translation>Arêtes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges along the principal stresses, in equilibrium.</source>
   <translation>Arêtes le long des contraintes principales, en équilibre.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long</source>
   <translation>Les arêtes ont à peu près cette longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges are about this long, whatever the sampling</source>
   <translation>Les arêtes ont à peu près cette longueur, quel que soit l'échantillonnage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of nodes may be turned this far from the shape of their kind</source>
   <translation>Les arêtes des nœuds peuvent être tournées d'autant par rapport à la forme de leur type</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Edges of the other family of lines are so many times as long</source>
   <translation>Les arêtes de l'autre famille de lignes sont autant de fois plus longues</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Edit net</source>
   <translation>Éditer le réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Edit settings</source>
   <translation>Modifier les réglages</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/source_net_view.py" />
   <source>Edit source</source>
   <translation>Éditer la source</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends</source>
   <translation>Extrémités</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ends of members are rigid, hinged, or have springs of this stiffness in kNm/rad</source>
   <translation>Les extrémités des barres sont rigides, articulées, ou ont des ressorts de cette raideur en kNm/rad (rigid, hinged ou le nombre)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Enneper's surface over the square |u|, |v| &lt;= reach (turned by 45 degrees for asymptotic).</source>
   <translation>Surface d'Enneper sur le carré |u|, |v| &lt;= portée (tournée de 45 degrés pour asymptotique).</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal</source>
   <translation>Égaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal angles</source>
   <translation>Angles égaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal angles diagonals</source>
   <translation>Angles égaux, diagonales</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Equal in STEP</source>
   <translation>Égal en STEP</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Even angle</source>
   <translation>Angle égal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Even angle diagonals</source>
   <translation>Angle égal des diagonales</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Evenness</source>
   <translation>Régularité</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every</source>
   <translation>Chaque</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every k-th parameter line</source>
   <translation>Une ligne paramétrique sur k</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Every so many lines of u and v stay</source>
   <translation>Une ligne de u et de v reste sur ce nombre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Export fabrication files</source>
   <translation>Fichiers de fabrication</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/fem_analyses.py" />
   <source>FEM analysis</source>
   <translation>Analyse FEM</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Fabrication files written to {}</source>
   <translation>Fichiers de fabrication écrits dans {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces at inner irregular vertices are left out, or asked for right angles too, which no smooth surface has there</source>
   <translation>Les faces aux sommets irréguliers intérieurs sont laissées de côté, ou on leur demande aussi des angles droits, qu'aucune surface lisse n'a là</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces keep the shape they have: paper that is bent.</source>
   <translation>Les faces gardent leur forme : du papier que l'on courbe.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Faces keep their shape the more of it there is, such as 10; none is usual</source>
   <translation>Plus il y en a, plus les faces gardent leur forme, par exemple 10 ; d'habitude aucun</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Fairness</source>
   <translation>Lissage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Few kinds</source>
   <translation>Peu de types</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Few kinds are wanted of these parts, once the net is reached</source>
   <translation>On veut peu de types de ces pièces, une fois le réseau atteint</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Files of the check written to {}</source>
   <translation>Fichiers de la vérification écrits dans {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Find the lightest section</source>
   <translation>Chercher la section la plus légère</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>Finding the exact net ...</source>
   <translation>Recherche du réseau exact ...</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structural_checks.py" />
   <source>Finding the lightest section</source>
   <translation>Recherche de la section la plus légère</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>First</source>
   <translation>Premier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>First formula</source>
   <translation>Première formule</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Fix</source>
   <translation>Fixer</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flange thickness</source>
   <translation>Épaisseur des semelles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces of any angles, near the surface that was drawn.</source>
   <translation>Faces planes d'angles quelconques, près de la surface dessinée.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces of steady proportions, and a dual net with parallel edges.</source>
   <translation>Faces planes aux proportions régulières, et un réseau dual aux arêtes parallèles.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces with an exact offset at constant thickness.</source>
   <translation>Faces planes avec un décalage exact d'épaisseur constante.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces with right angles; torsion-free beams.</source>
   <translation>Faces planes à angles droits ; poutres sans torsion.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces, and lines that lie in planes of their own.</source>
   <translation>Faces planes, et lignes qui sont chacune dans un plan.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat faces, each with a circle through its corners.</source>
   <translation>Faces planes, chacune avec un cercle par ses coins.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flat net in the plane z = 0, centred at the origin; rectangles, normals along +z.</source>
   <translation>Réseau plat dans le plan z = 0, centré à l'origine ; rectangles, normales selon +z.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/flat_patterns.py" />
   <source>Flat patterns</source>
   <translation>Développés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Flatness</source>
   <translation>Planéité</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Flip net</source>
   <translation>Retourner le réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Fold</source>
   <translation>Pli</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Folder for the fabrication files</source>
   <translation>Dossier des fichiers de fabrication</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot at</source>
   <translation>Pieds à</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot height</source>
   <translation>Hauteur de pied</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Foot plate</source>
   <translation>Platine de pied</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>For buckling and second order each member has so many pieces</source>
   <translation>Pour le flambement et le second ordre chaque barre a tant de morceaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>For developable nets: the sheet bends and hardly stretches.</source>
   <translation>Pour les réseaux développables : la feuille se courbe et ne s'étire guère.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Force</source>
   <translation>Force</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Forces</source>
   <translation>Forces</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Forces under equal loads</source>
   <translation>Forces sous charges égales</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Four faces for each, parameter lines kept</source>
   <translation>Quatre faces pour chacune, lignes paramétriques conservées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame</source>
   <translation>Cadre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Frame width</source>
   <translation>Largeur de cadre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>FreeCAD's Python was not found, or it has no pip. Install pip for Python {} with your system's package manager, then try again.</source>
   <translation>Le Python de FreeCAD est introuvable ou n'a pas pip. Installez pip pour Python {} avec le gestionnaire de paquets de votre système, puis réessayez.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>From</source>
   <translation>De</translation>
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
   <translation>Joint</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gap to reference</source>
   <translation>Écart à la référence</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gasket</source>
   <translation>Joint</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Gauss curvature</source>
   <translation>Courbure de Gauss</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Gauss image</source>
   <translation>Image de Gauss</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Geodesic</source>
   <translation>Géodésique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Geodesic diagonals</source>
   <translation>Diagonales géodésiques</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Glide</source>
   <translation>Glisser</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Glide on ...</source>
   <translation>Glisser sur ...</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Grain</source>
   <translation>Sens du fil</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Handle</source>
   <translation>Poignée</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Handles</source>
   <translation>Poignées</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>Hardly possible: {}</source>
   <translation>Guère possible : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hardware in STEP</source>
   <translation>Quincaillerie dans STEP</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Have them found: the fewest that the surface needs.</source>
   <translation>Les faire trouver : le minimum qu'exige la surface.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Height</source>
   <translation>Hauteur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Helicoid around z, radii from -radius to radius.</source>
   <translation>Hélicoïde autour de z, rayons de -rayon à rayon.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Hold</source>
   <translation>Tenir</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hole</source>
   <translation>Trou</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>How many lines meet in the one to be added.</source>
   <translation>Combien de lignes se rencontrent dans celui qui est ajouté.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub diameter</source>
   <translation>Diamètre du moyeu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Hub wall</source>
   <translation>Paroi du moyeu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>I</source>
   <translation>I</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>IFC 4 holds all parts, with quantities and properties</source>
   <translation>IFC 4 contient toutes les pièces, avec quantités et propriétés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Image only</source>
   <translation>Image seule</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Imperfection</source>
   <translation>Imperfection</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Import quad mesh</source>
   <translation>Importer un maillage de quadrilatères</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Install</source>
   <translation>Installer</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Installed, but Python does not find it in {}.</source>
   <translation>Installé, mais Python ne le trouve pas dans {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Installed. Start FreeCAD again to use everything.</source>
   <translation>Installé. Redémarrez FreeCAD pour tout utiliser.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Installing {}. This takes some minutes.</source>
   <translation>Installation de {}. Cela prend quelques minutes.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Inverted in a sphere</source>
   <translation>Inversé dans une sphère</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Irregular</source>
   <translation>Irréguliers</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Irregular vertices</source>
   <translation>Sommets irréguliers</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Isometric</source>
   <translation>Isométrique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Isometric nets: faces keep the shape that this net has; empty: as it starts</source>
   <translation>Réseaux isométriques : les faces gardent la forme qu'a ce réseau ; vide : comme il commence</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Isometry</source>
   <translation>Isométrie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>It is asked of the diagonals of the faces, not of the edges</source>
   <translation>On le demande aux diagonales des faces, pas aux arêtes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Joints</source>
   <translation>Assemblages</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>K factor</source>
   <translation>Facteur k</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Keep border</source>
   <translation>Garder le bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Keep the last line where the step misses it</source>
   <translation>Garder la dernière ligne là où le pas la manque</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kerf</source>
   <translation>Trait de coupe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kind</source>
   <translation>Type</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds</source>
   <translation>Types</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds of edges</source>
   <translation>Types d'arêtes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds of nodes</source>
   <translation>Types de nœuds</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Kinds of panels</source>
   <translation>Types de panneaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Label sheet</source>
   <translation>Planche d'étiquettes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Labels</source>
   <translation>Étiquettes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Latitudes</source>
   <translation>Latitudes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Layers</source>
   <translation>Couches</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Layout</source>
   <translation>Disposition</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least length</source>
   <translation>Longueur minimale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least rest</source>
   <translation>Chute minimale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Least width</source>
   <translation>Largeur minimale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Length</source>
   <translation>Longueur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Lengths are in mm, curvatures in 1/m, angles in degrees.</source>
   <translation>Les longueurs sont en mm, les courbures en 1/m, les angles en degrés.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Less than 1 moves the centre farther away</source>
   <translation>Moins de 1 éloigne le centre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Let the shape swing</source>
   <translation>Faire osciller la forme</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Levels</source>
   <translation>Niveaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Lie on</source>
   <translation>Posés sur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lift</source>
   <translation>Relever</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Line elements of the members</source>
   <translation>Éléments linéiques des barres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Line planes</source>
   <translation>Plans des lignes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Lines</source>
   <translation>Lignes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Lines of the members</source>
   <translation>Lignes des barres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines stand at even distances, or at equal steps of the parameters</source>
   <translation>Les lignes sont à distances égales ou à pas égaux des paramètres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines that all cross at one angle, faces not flat.</source>
   <translation>Des lignes qui se croisent toutes sous un seul angle, des faces non planes.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines that cross at right angles, faces not flat.</source>
   <translation>Lignes qui se croisent à angle droit, faces non planes.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u and v lie in two layers, u above, the middles of their sections this far apart</source>
   <translation>Les lignes u et v sont en deux couches, u au-dessus, les milieux de leurs sections à cette distance</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Lines u, lines v and diagonals of a web are these: a asymptotic, g geodesic</source>
   <translation>Lignes u, lignes v et diagonales d'un tissu sont : a asymptotiques, g géodésiques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Load at a vertex</source>
   <translation>Charge par sommet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Load of 1 mm2</source>
   <translation>Charge par mm2</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Loads</source>
   <translation>Charges</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_loads.py" />
   <source>Loads: {}</source>
   <translation>Charges : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Louvre axis</source>
   <translation>Axe des brise-soleil</translation>
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
   <translation>Matériau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Mean curvature</source>
   <translation>Courbure moyenne</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Measure</source>
   <translation>Mesure</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Medial lines</source>
   <translation>Lignes médianes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/fem_analysis.py" />
   <source>Members</source>
   <translation>Barres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Members buckle in so many times their length</source>
   <translation>Les barres flambent sur tant de fois leur longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Midpoints of the edges: a parallelogram in each face</source>
   <translation>Milieux des arêtes : un parallélogramme dans chaque face</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Mirror</source>
   <translation>Miroir</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Modes</source>
   <translation>Modes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Moebius transformation</source>
   <translation>Transformation de Möbius</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it bends lines more evenly on the way; none is usual</source>
   <translation>Plus il y en a, plus les lignes se courbent régulièrement en chemin ; d'habitude aucun</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it draws lines straighter on the way; 0.01 is usual</source>
   <translation>Plus il y en a, plus les lignes sont tirées droites en chemin ; d'habitude 0,01</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps direction and length of edges; 0.02 is usual</source>
   <translation>Plus il y en a, plus les arêtes gardent direction et longueur ; d'habitude 0,02</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps pairs of faces orthogonal; 0.001 is usual</source>
   <translation>Plus il y en a, plus les paires de faces restent orthogonales ; d'habitude 0,001</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it keeps vertices nearer to where they are; 0.003 is usual</source>
   <translation>Plus il y en a, plus les sommets restent près de leur place ; d'habitude 0,003</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>More of it moves neighbours more alike; 0.1 is usual</source>
   <translation>Plus il y en a, plus les voisins se déplacent de même ; d'habitude 0,1</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Move</source>
   <translation>Déplacer</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Move there</source>
   <translation>Déplacer là</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Moved, turned and scaled</source>
   <translation>Déplacé, tourné et mis à l'échelle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Moving</source>
   <translation>Mobile</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Multi patch</source>
   <translation>Carreau multi</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Multi-net</source>
   <translation>Multi-réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Multi-net: no, off by {:.1e} over all rectangles of lines</source>
   <translation>Multi-réseau : non, écart de {:.1e} sur tous les rectangles de lignes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Multi-net: no, the mesh is not of grid type</source>
   <translation>Multi-réseau : non, les quadrilatères ne forment pas une grille</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Multi-net: yes, to {:.1e} over all rectangles of lines</source>
   <translation>Multi-réseau : oui, à {:.1e} près sur tous les rectangles de lignes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Names and marks</source>
   <translation>Noms et marques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Narrowest</source>
   <translation>Le plus étroit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Near</source>
   <translation>Près</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Nest on sheets</source>
   <translation>Imbriquer sur des tôles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Net</source>
   <translation>Réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Nets joined into one where borders meet, also within one net</source>
   <translation>Réseaux réunis en un seul là où les bords se touchent, même dans un seul réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>New vertices lie in the middle, or all are smoothed</source>
   <translation>Les nouveaux sommets sont au milieu, ou tous sont lissés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Next buckling shape</source>
   <translation>Mode de flambement suivant</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Next combination</source>
   <translation>Combinaison suivante</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Next diagram of forces</source>
   <translation>Diagramme d'efforts suivant</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>No boundary beams</source>
   <translation>Sans poutres de bord</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>No recommendation for this mesh.</source>
   <translation>Pas de recommandation pour ce maillage.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Node</source>
   <translation>Nœud</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Node axes</source>
   <translation>Axes des nœuds</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>None</source>
   <translation>Aucune</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Normal</source>
   <translation>Normale</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Not now</source>
   <translation>Pas maintenant</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Off by</source>
   <translation>Écart</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Off the surface by {} at most, {} on average.</source>
   <translation>À {} de la surface au plus, {} en moyenne.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Offset</source>
   <translation>Décalage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>One of the two meshes of face diagonals</source>
   <translation>Un des deux maillages des diagonales de faces</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>One turn rises by this</source>
   <translation>Un tour monte d'autant</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Optimise</source>
   <translation>Optimiser</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/again.py" />
   <source>Optimise again</source>
   <translation>Optimiser de nouveau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Optimise for: {} (off by {:.1e} on average)</source>
   <translation>Optimiser pour : {} (écart moyen {:.1e})</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Optimise {}</source>
   <translation>Optimiser {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/requirements.py" />
   <source>Ortho: these Python packages are missing: {}</source>
   <translation>Ortho : ces paquets Python manquent : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonal multi-net in elliptic coordinates</source>
   <translation>Multi-réseau orthogonal en coordonnées elliptiques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonal multi-net of a polyline drawn on a quadric</source>
   <translation>Multi-réseau orthogonal d'une polyligne dessinée sur une quadrique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonality</source>
   <translation>Orthogonalité</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Orthogonality diagonals</source>
   <translation>Orthogonalité diag.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Other side up, or families u and v exchanged</source>
   <translation>L'autre côté en haut, ou familles u et v échangées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Other than four lines meet here: auto for the fewest that the surface needs, none, or a file of rows x y z and 3, 5 or 6 lines</source>
   <translation>Ici se rencontrent plus ou moins de quatre lignes : auto pour le moins que la surface demande, none pour aucune, ou un fichier de lignes x y z et 3, 5 ou 6</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Outside</source>
   <translation>Extérieur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Overhang</source>
   <translation>Débord</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Overlays</source>
   <translation>Superpositions</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Own shape</source>
   <translation>Forme propre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Packages for the Ortho workbench</source>
   <translation>Paquets pour l'atelier Ortho</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Packing</source>
   <translation>Rangement</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel edge</source>
   <translation>Chant des panneaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel shear</source>
   <translation>Cisaillement</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panel thickness</source>
   <translation>Épaisseur des panneaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels</source>
   <translation>Panneaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels and lengths of edges may be this far from the shape of their kind</source>
   <translation>Panneaux et longueurs d'arêtes peuvent s'écarter d'autant de la forme de leur type</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels weigh this much by their surface, kN/m2</source>
   <translation>Les panneaux pèsent autant par surface, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Panels with what holds them have this shear stiffness G t, kN/mm; with 0 they are load only</source>
   <translation>Les panneaux avec ce qui les tient ont cette rigidité de cisaillement G t, kN/mm ; avec 0 ils ne sont que charge</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Paper</source>
   <translation>Papier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parallel edges, each diagonal parallel to the other one; of a sphere a minimal surface</source>
   <translation>Arêtes parallèles, chaque diagonale parallèle à l'autre ; d'une sphère une surface minimale</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Parameter lines u and v</source>
   <translation>Lignes paramétriques u et v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Parts are made along lines of these families.</source>
   <translation>Les pièces sont faites le long des lignes de ces familles.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>Parts are made along these lines only, numbered such as 0, 3.</source>
   <translation>Des pièces ne sont faites que le long de ces lignes, numérotées par exemple 0, 3.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Parts are nested on sheets.</source>
   <translation>Les pièces sont imbriquées sur des tôles.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts in 3DM</source>
   <translation>Pièces en 3DM</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Parts in IFC</source>
   <translation>Pièces en IFC</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pattern</source>
   <translation>Développé</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Periods</source>
   <translation>Périodes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Pick</source>
   <translation>Choisir</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/form_panel.py" />
   <source>Pick supports</source>
   <translation>Choisir les appuis</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_picking.py" />
   <source>Pick vertices</source>
   <translation>Choisir des sommets</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Picture (*.png)</source>
   <translation>Image (*.png)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Picture written to {}</source>
   <translation>Image écrite dans {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Piece length</source>
   <translation>Longueur des pièces</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pieces</source>
   <translation>Morceaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pitch</source>
   <translation>Pas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Placement</source>
   <translation>Placement</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Planar nets: the diagonals of a face are this far apart at most</source>
   <translation>Réseaux plans : les diagonales d'une face sont distantes d'autant au plus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Planarity</source>
   <translation>Planéité</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Plane lines</source>
   <translation>Lignes planes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Point</source>
   <translation>Point</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Point loads</source>
   <translation>Charges ponctuelles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Points</source>
   <translation>Points</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Points where the medial lines of the faces cross</source>
   <translation>Points où les lignes médianes des faces se croisent</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Position</source>
   <translation>Position</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post diameter</source>
   <translation>Diamètre de poteau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Post wall</source>
   <translation>Paroi de poteau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>Press the mouse on the surface and draw a line that the net runs along; Esc leaves it out.</source>
   <translation>Pressez la souris sur la surface et dessinez une ligne que le réseau suit ; Échap l'abandonne.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Press the mouse on the surface where there is to be one more.</source>
   <translation>Appuyer la souris sur la surface là où il doit y en avoir un de plus.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Pressure</source>
   <translation>Pression</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Prices</source>
   <translation>Prix</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Profile</source>
   <translation>Profil</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Profile of (radius, height) points turned about z, n points along it by interpolation.</source>
   <translation>Profil de points (rayon, hauteur) tourné autour de z, n points le long par interpolation.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>Put back.</source>
   <translation>Remis en place.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Quad mesh</source>
   <translation>Maillage de quadrilatères</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Quadric</source>
   <translation>Quadrique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/sources.py" />
   <source>Quads from triangles</source>
   <translation>Quads de triangles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Quads that the border cuts are set onto it, or left out</source>
   <translation>Les quads que le bord coupe sont mis dessus ou laissés de côté</translation>
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
   <translation>Rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Ratio</source>
   <translation>Rapport</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Reach</source>
   <translation>Portée</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>Recommended: &lt;b&gt;{}&lt;/b&gt;</source>
   <translation>Recommandé : &lt;b&gt;{}&lt;/b&gt;</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Redraws</source>
   <translation>Images</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Reflect</source>
   <translation>Refléter</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Reflection lines</source>
   <translation>Lignes de réflexion</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/sources.py" />
   <source>Remeshing to quads</source>
   <translation>Remaillage en quadrilatères</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>Remove</source>
   <translation>Enlever</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>Reset</source>
   <translation>Réinitialiser</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Residuals up to this count as zero</source>
   <translation>Les résidus jusqu'à cette valeur comptent pour zéro</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Reverse</source>
   <translation>Inverser</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rhino gets parts, the net, its lines and axes, on layers</source>
   <translation>Rhino reçoit les pièces, le réseau, ses lignes et ses axes, sur des calques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rings</source>
   <translation>Anneaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rings or rows of faces cut off</source>
   <translation>Anneaux ou rangées de faces coupés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rise</source>
   <translation>Flèche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rounded</source>
   <translation>Arrondi</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rows</source>
   <translation>Rangées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Rule</source>
   <translation>Règle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Rulings of strips</source>
   <translation>Génératrices des bandes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Running ...</source>
   <translation>En cours ...</translation>
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
   <translation>Fichiers STEP</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sampling</source>
   <translation>Échantillonnage</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Save picture</source>
   <translation>Enregistrer l'image</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Saw</source>
   <translation>Trait de scie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Saw cut</source>
   <translation>Trait de scie</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Saw list</source>
   <translation>Sciage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Scale</source>
   <translation>Échelle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Scherk's surface z = ln(cos y / cos x).</source>
   <translation>Surface de Scherk z = ln(cos y / cos x).</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Second</source>
   <translation>Second</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Second formula</source>
   <translation>Seconde formule</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Second order</source>
   <translation>Second ordre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section</source>
   <translation>Section</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Section and material are those of these beams or lamellas.</source>
   <translation>Section et matériau sont ceux de ces poutres ou lamelles.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section tolerance</source>
   <translation>Tolérance</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Section width</source>
   <translation>Largeur de la section</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sections stand as those of beams do, or as lamellas of plate:THICKNESSxWIDTH: standing, lying or tilted as the net wants it</source>
   <translation>Les sections se tiennent comme celles de poutres, ou en lamelles plate:ÉPAISSEURxLARGEUR : debout, couchées ou inclinées comme le réseau le demande</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Seed</source>
   <translation>Graine</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Self weight</source>
   <translation>Poids propre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Semi axes</source>
   <translation>Demi-axes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/nets.py" />
   <source>Settings of the net</source>
   <translation>Réglages du réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet</source>
   <translation>Plaque</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Sheet height</source>
   <translation>Hauteur de tôle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet of the tangents of a spine, by rulings (v) and involutes (u).</source>
   <translation>Feuille des tangentes d'une courbe directrice, par génératrices (v) et développantes (u).</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sheet sizes</source>
   <translation>Formats de tôle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Sheet width</source>
   <translation>Largeur de tôle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>Sheet {}</source>
   <translation>Tôle {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Show the field</source>
   <translation>Montrer le champ</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Show the net</source>
   <translation>Montrer le réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Show the scale</source>
   <translation>Montrer l'échelle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Singular vertices</source>
   <translation>Sommets singuliers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Singularities</source>
   <translation>Singularités</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Site origin</source>
   <translation>Origine du site</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Site rotation</source>
   <translation>Rotation du site</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Size</source>
   <translation>Taille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slivers</source>
   <translation>Chutes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slots</source>
   <translation>Entailles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Slots leave this part of the height of lamellas that cross in one layer; with 1 there are none</source>
   <translation>Les entailles laissent cette part de la hauteur des lamelles qui se croisent en une couche ; avec 1 il n'y en a pas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Smooth</source>
   <translation>Lisse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Smooth motion</source>
   <translation>Mouvement lisse</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow</source>
   <translation>Neige</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow also lies on one half, as a case of its own: the half towards this direction</source>
   <translation>La neige est aussi sur une moitié, comme un cas à part : celle dans cette direction</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow side</source>
   <translation>Côté enneigé</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Snow weighs this much by the plan, kN/m2</source>
   <translation>La neige pèse autant en plan, kN/m2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many modes of buckling are found</source>
   <translation>Autant de modes de flambement sont cherchés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>So many processes share the work.</source>
   <translation>Autant de processus se partagent le travail.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rings of faces are cut off at the border</source>
   <translation>Tant d'anneaux de faces sont coupés au bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many rows are cut off at the starts and ends of u and v</source>
   <translation>Tant de rangées sont coupées aux débuts et aux fins de u et v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many times four faces are made of one</source>
   <translation>Tant de fois quatre faces sont faites d'une</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>So many vertices stand along u and along v</source>
   <translation>Il y a tant de sommets selon u et selon v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Socket depth</source>
   <translation>Profondeur des douilles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spacing</source>
   <translation>Espacement</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Sphere by meridians and parallels; planar, circular, equal diagonals, vertices on the sphere.</source>
   <translation>Sphère par méridiens et parallèles ; plane, circulaire, diagonales égales, sommets sur la sphère.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Spheres of vertex stars</source>
   <translation>Sphères des étoiles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spherical stars</source>
   <translation>Étoiles sphériques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spherical stars diagonals</source>
   <translation>Étoiles sphériques, diagonales</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Spine</source>
   <translation>Courbe directrice</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Splice every</source>
   <translation>Joint tous les</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stands on</source>
   <translation>Appuis</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Start</source>
   <translation>Démarrer</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>State</source>
   <translation>État</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Stays</source>
   <translation>Reste</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Step</source>
   <translation>Pas</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Step {} of {}: {}</source>
   <translation>Étape {} sur {} : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stock</source>
   <translation>Longueur en stock</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structures.py" />
   <source>Stock length</source>
   <translation>Longueur de barre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stock lengths</source>
   <translation>Longueurs en stock</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Stop</source>
   <translation>Arrêter</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Stopped. A change or OK begins again.</source>
   <translation>Arrêté. Un changement ou OK recommence.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>Stopped. Nothing was installed.</source>
   <translation>Arrêté. Rien n'a été installé.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Stopped. OK keeps this state, Start goes on.</source>
   <translation>Arrêté. OK garde cet état, Démarrer continue.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Straight upright lamellas that all cross at one angle.</source>
   <translation>Lamelles droites et debout qui se croisent toutes sous un même angle.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strength</source>
   <translation>Intensité</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress</source>
   <translation>Contrainte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a millimetre of edge has this weight</source>
   <translation>Réseaux de contraintes : un millimètre d'arête a ce poids</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: a square millimetre carries this load, downwards</source>
   <translation>Réseaux de contraintes : un millimètre carré porte cette charge, vers le bas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: edges may carry these forces</source>
   <translation>Réseaux de contraintes : les arêtes peuvent porter ces forces</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: every vertex carries this load, downwards</source>
   <translation>Réseaux de contraintes : chaque sommet porte cette charge, vers le bas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: the shell whose stresses the lines follow stands on this</source>
   <translation>Réseaux de contraintes : la coque dont les lignes suivent les contraintes repose sur ceci</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Stress nets: this carries the loads: boundary, which slides along its own curve but for its corners; corners or vertices such as 0,5,12, which stay; empty: as the net needs</source>
   <translation>Réseaux de contraintes : ceci porte les charges : boundary, le bord, qui glisse le long de sa propre courbe sauf en ses coins ; corners ou des sommets comme 0,5,12, qui restent ; vide : ce que le réseau demande</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strip</source>
   <translation>Bande</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along u</source>
   <translation>Bandes suivant u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along u have this angle to the surface: 90 stands, 180 lies</source>
   <translation>Les bandes selon u ont cet angle avec la surface : 90 debout, 180 couchées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along v</source>
   <translation>Bandes suivant v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Strips along v have this angle to the surface: 90 stands, 180 lies</source>
   <translation>Les bandes selon v ont cet angle avec la surface : 90 debout, 180 couchées</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>Strokes</source>
   <translation>Courbes guides</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structural_checks.py" />
   <source>Structural check</source>
   <translation>Vérification statique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Structures</source>
   <translation>Structures</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>Supports</source>
   <translation>Appuis</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Swap</source>
   <translation>Permuter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Symmetry</source>
   <translation>Symétrie</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>T</source>
   <translation>T</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>T range</source>
   <translation>Plage de t</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>That is more than the {} allowed.</source>
   <translation>C'est plus que les {} permis.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>That is more than the {} that were allowed, at face {}.</source>
   <translation>C'est plus que les {} admis, à la face {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>The Ortho workbench needs Python packages that FreeCAD does not find: {names}.

Install downloads them with what they need, up to 2 GB on disk, into FreeCAD's own folder for add-ons:
{folder}
Nothing else on this computer is changed.</source>
   <translation>L'atelier Ortho a besoin de paquets Python que FreeCAD ne trouve pas : {names}.

Installer les télécharge avec ce dont ils dépendent, jusqu'à 2 Go sur le disque, dans le dossier de FreeCAD pour les extensions :
{folder}
Rien d'autre n'est modifié sur cet ordinateur.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>The Python package {} is not installed.</source>
   <translation>Le paquet Python {} n'est pas installé.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along x rises by this, or hangs where it is negative</source>
   <translation>L'arc selon x monte d'autant, ou pend si c'est négatif</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The arch along y rises by this, or hangs where it is negative</source>
   <translation>L'arc selon y monte d'autant, ou pend si c'est négatif</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The border is left a zigzag, or closed by narrow quads</source>
   <translation>Le bord reste en zigzag, ou est fermé par des quads étroits</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The cables have this force density, force / length</source>
   <translation>Les câbles ont cette densité de force, force / longueur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The chosen vertex goes to this place.</source>
   <translation>Le sommet choisi va à cet endroit.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The chosen vertices are no handles any more.</source>
   <translation>Les sommets choisis ne sont plus des poignées.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The curve goes through these points instead, about the centre</source>
   <translation>La courbe passe plutôt par ces points, autour du centre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The edges carry this load, force / mm</source>
   <translation>Les arêtes portent cette charge, force / mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The ends of a curve that is no preset are joined</source>
   <translation>Les extrémités d'une courbe qui n'est pas prédéfinie sont jointes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this load, force / mm2</source>
   <translation>Les faces portent cette charge, force / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The faces carry this pressure along their normals, force / mm2</source>
   <translation>Les faces portent cette pression selon leurs normales, force / mm2</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The families u and v change places</source>
   <translation>Les familles u et v échangent leurs places</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of the two holds the first vertex</source>
   <translation>Le premier des deux contient le premier sommet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The first of them follows this formula of s</source>
   <translation>La première suit cette formule de s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix has this radius</source>
   <translation>L'hélice a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The helix turns by this angle</source>
   <translation>L'hélice tourne de cet angle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The imperfection is this large</source>
   <translation>L'imperfection a cette grandeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The inversion has its centre here</source>
   <translation>L'inversion a son centre ici</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The largest displacement that passes is this part of the second longest side of the net's box: 200 for 1/200</source>
   <translation>Le plus grand déplacement admis est cette part du deuxième plus long côté de la boîte du réseau : 200 pour 1/200</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The largest gap of a face is {}, of face {}.</source>
   <translation>Le plus grand écart d'une face est {}, à la face {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The largest miss is {}.</source>
   <translation>L'écart le plus grand est {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/residual_plot.py" />
   <source>The largest residuals by steps. Below the dashed line they count as zero.</source>
   <translation>Les plus grands résidus par pas. Sous la ligne tiretée, ils comptent pour zéro.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The last point is joined with the first</source>
   <translation>Le dernier point est joint au premier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The lower end has this radius</source>
   <translation>L'extrémité basse a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members are made of this</source>
   <translation>Les barres sont faites de ceci</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The members have this profile; groups another one after it, as tube:100x60x5,border=tube:120x60x5</source>
   <translation>Les barres ont ce profil ; des groupes un autre à la suite, comme tube:100x60x5,border=tube:120x60x5</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane has this stress, force / length</source>
   <translation>La membrane a cette contrainte, force / longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The membrane's border cable has this force</source>
   <translation>Le câble de bord de la membrane a cette force</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>The mesh is {:.1e} from it on average</source>
   <translation>Le maillage en est à {:.1e} en moyenne</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The middle of sections lies this far above the net, along its axes</source>
   <translation>Le milieu des sections est à cette distance au-dessus du réseau, selon ses axes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror image comes alone</source>
   <translation>L'image miroir vient seule</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane goes through this point</source>
   <translation>Le plan de symétrie passe par ce point</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The mirror plane has this normal</source>
   <translation>Le plan de symétrie a cette normale</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The mouse draws handles this way.</source>
   <translation>La souris tire les poignées de cette façon.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The multi-net guide keeps patches of so many faces along and across orthogonal</source>
   <translation>Le guide multi-réseau garde orthogonaux des morceaux de tant de faces en long et en travers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The narrowest circle has this radius</source>
   <translation>Le cercle le plus étroit a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net and its mirror image, the seam merged</source>
   <translation>Le réseau et son image miroir, la couture fusionnée</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of u</source>
   <translation>Le réseau couvre cette part de l'étendue de u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net covers this part of the range of v</source>
   <translation>Le réseau couvre cette part de l'étendue de v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>The net follows in a moment.</source>
   <translation>Le réseau suit dans un instant.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net follows these lines of the surface</source>
   <translation>Le réseau suit ces lignes de la surface</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these angles about the axis</source>
   <translation>Le réseau va du premier au second de ces angles autour de l'axe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second of these latitudes</source>
   <translation>Le réseau va de la première à la seconde de ces latitudes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t of the confocal family</source>
   <translation>Le réseau va du premier au second t de la famille confocale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes from the first to the second t; with 0 and 0 it keeps clear of both ends</source>
   <translation>Le réseau va du premier au second t ; avec 0 et 0 il reste à l'écart des deux bouts</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net goes on along these axes as its mirror image, as x,y</source>
   <translation>Le réseau continue le long de ces axes comme son image en miroir, comme x,y</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The net has changed meanwhile. Start begins anew.</source>
   <translation>Le réseau a changé entre-temps. Démarrer recommence.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The net is as it was before.</source>
   <translation>Le réseau est comme avant.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>The net is hidden: nothing of this is seen.</source>
   <translation>Le réseau est masqué : rien de ceci n'est visible.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is its own mirror image in these planes: auto for those that the surface has, or those across an axis, through the middle of the surface</source>
   <translation>Le réseau est sa propre image en miroir dans ces plans : auto pour ceux de la surface, ou ceux perpendiculaires à un axe, par le milieu de la surface</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is made of cables, or is a membrane of one stress</source>
   <translation>Le réseau est fait de câbles, ou est une membrane de contrainte égale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is moved by this</source>
   <translation>Le réseau est déplacé de ceci</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is scaled by this factor</source>
   <translation>Le réseau est mis à l'échelle par ce facteur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>The net is this already: {}</source>
   <translation>Le réseau l'est déjà : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this long along x</source>
   <translation>Le réseau a cette longueur selon x</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is this wide across</source>
   <translation>Le réseau a cette largeur en travers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is to become this one; asymptotic and cmc lines run at 45 degrees to curvature, those of asymptotic-angle where the surface does not bend, stress lines as a shell carries its weight</source>
   <translation>Le réseau doit devenir celui-ci ; les lignes asymptotiques et cmc vont à 45 degrés de la courbure, celles de asymptotic-angle là où la surface ne se courbe pas, celles de contraintes comme une coque porte son poids</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net is turned by these angles about x, then y, then z</source>
   <translation>Le réseau est tourné de ces angles autour de x, puis y, puis z</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>The net keeps being its own mirror image in the plane through 0.</source>
   <translation>Le réseau reste sa propre image miroir dans le plan par 0.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches so far over the surface, farther where this is larger</source>
   <translation>Le réseau s'étend d'autant sur la surface, plus loin si c'est plus grand</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net reaches this far from the axis on both sides</source>
   <translation>Le réseau s'étend d'autant de part et d'autre de l'axe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net runs along these lines, drawn on the surface</source>
   <translation>Le réseau suit ces lignes dessinées sur la surface</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The net stands here, turned like this</source>
   <translation>Le réseau est ici, tourné ainsi</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>The net was changed.</source>
   <translation>Le réseau a été modifié.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The offset lies this far along the normals, below where it is negative</source>
   <translation>Le décalage est à cette distance selon les normales, au-dessous si elle est négative</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The other side is turned up</source>
   <translation>L'autre côté est tourné vers le haut</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>The packages could not be installed:</source>
   <translation>Les paquets n'ont pas pu être installés :</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>The parts lie on these beams.</source>
   <translation>Les pièces reposent sur ces poutres.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline goes through these points, in the frame of the quadric</source>
   <translation>La ligne brisée passe par ces points, dans le repère de la quadrique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The polyline lies on this quadric</source>
   <translation>La ligne brisée est sur cette quadrique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>The range goes by powers of ten, such as -6.</source>
   <translation>La plage va par puissances de dix, par exemple -6.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The result may be this far off the surface, or the start where none is given</source>
   <translation>Le résultat peut s'écarter d'autant de la surface, ou du départ si aucune n'est donnée</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The second of them follows this formula of s</source>
   <translation>La seconde suit cette formule de s</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes are this long, the largest comes first</source>
   <translation>Les demi-axes ont ces longueurs, le plus grand vient d'abord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of lambda = 0 are this long, the largest comes first</source>
   <translation>Les demi-axes de lambda = 0 ont ces longueurs, le plus grand vient d'abord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The semi-axes of the quadric are this long</source>
   <translation>Les demi-axes de la quadrique ont ces longueurs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The shape moved by up to {} ({:.1f} mean edges). Its size was {} and is {}.</source>
   <translation>La forme s'est déplacée jusqu'à {} ({:.1f} arêtes moyennes). Sa taille était {} et est {}.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>The sheets are this high.</source>
   <translation>Les tôles ont cette hauteur.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>The sheets are this wide.</source>
   <translation>Les tôles ont cette largeur.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>The source of this net has changed since; it stays as it is.</source>
   <translation>La source de ce réseau a changé depuis ; il reste tel quel.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>The source of this net has changed. Start begins anew with what it makes now.</source>
   <translation>La source de ce réseau a changé. Démarrer recommence avec ce qu'elle fait à présent.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has its centre here</source>
   <translation>La sphère a son centre ici</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The sphere has this radius</source>
   <translation>La sphère a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface grows in proportion to this length</source>
   <translation>La surface grandit en proportion de cette longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has so many waves along its axis</source>
   <translation>La surface a tant d'ondes le long de son axe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface has this radius</source>
   <translation>La surface a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The surface is this high</source>
   <translation>La surface a cette hauteur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The tangents of these points make the sheet; empty for a helix</source>
   <translation>Les tangentes en ces points font la surface ; vide pour une hélice</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two directions meet at this angle</source>
   <translation>Les deux directions se rencontrent sous cet angle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>The two directions that lines follow; grey where curvature does not say much.</source>
   <translation>Les deux directions que suivent les lignes ; gris où la courbure ne dit pas grand-chose.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates follow this curve</source>
   <translation>Les deux autres coordonnées suivent cette courbe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The two other coordinates have these values instead</source>
   <translation>Les deux autres coordonnées ont plutôt ces valeurs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The upper end has this radius</source>
   <translation>L'extrémité haute a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The weight of the members is a load</source>
   <translation>Le poids des barres est une charge</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>The weight of this structure is a load by the surface.</source>
   <translation>Le poids de cette structure est une charge de surface.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>The widest circle has this radius</source>
   <translation>Le cercle le plus large a ce rayon</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>The wind has this pressure in kN/m2 and blows this way: 0.6@x; 0.6@-y.</source>
   <translation>Le vent a cette pression en kN/m2 et souffle par là : 0.6@x; 0.6@-y.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>There may be so many kinds; 0 is as few as can be found</source>
   <translation>Il peut y avoir tant de types ; 0 : aussi peu que possible</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or numbers of vertices, each with :pinned, :fixed, :sliding (up and down only) or :springs=X/Y/Z (kN/mm), joined by +</source>
   <translation>Ceci est tenu : boundary, corners ou des numéros de sommets, chacun avec :pinned, :fixed, :sliding (de haut en bas seulement) ou :springs=X/Y/Z (kN/mm), joints par +</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These are held: boundary, corners or vertices as 0,5,12</source>
   <translation>Ceci est tenu : boundary, corners ou des sommets comme 0,5,12</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These lines lie in planes of their own</source>
   <translation>Ces lignes sont dans des plans à elles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These points (radius, height) are turned about z</source>
   <translation>Ces points (rayon, hauteur) sont tournés autour de z</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>These supports are raised first, VERTEX:HEIGHT in mm as 0:1500; 20:900</source>
   <translation>Ces appuis sont d'abord levés, SOMMET:HAUTEUR en mm comme 0:1500; 20:900</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>These vertices carry these forces in kN: 12:0,0,-5; 13:0,0,-5.</source>
   <translation>Ces sommets portent ces forces en kN : 12:0,0,-5; 13:0,0,-5.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>These vertices do not move; numbers such as 0,5,12 work too.</source>
   <translation>Ces sommets ne bougent pas ; des numéros comme 0,5,12 conviennent aussi.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Thickness</source>
   <translation>Épaisseur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This elliptic coordinate has the role of t</source>
   <translation>Cette coordonnée elliptique a le rôle de t</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This part of the range is left free at each end</source>
   <translation>Cette part de l'étendue reste libre à chaque bout</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>This point stays where it is</source>
   <translation>Ce point reste où il est</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>This quantity colours the net.</source>
   <translation>Cette grandeur colore le réseau.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Three families of straight slats, which brace each other.</source>
   <translation>Trois familles de lattes droites qui se raidissent.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Through</source>
   <translation>Continue</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tilt</source>
   <translation>Inclinaison</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tilted lamellas that unroll straight, one angle a family.</source>
   <translation>Lamelles inclinées qui se déroulent droites, un angle par famille.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Time limit (s)</source>
   <translation>Limite de temps (s)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>To</source>
   <translation>À</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Tolerance</source>
   <translation>Tolérance</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Top radius</source>
   <translation>Rayon supérieur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Triangle mesh</source>
   <translation>Maillage de triangles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/remesh_panel.py" />
   <source>Triangles</source>
   <translation>Triangles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Trim</source>
   <translation>Éboutage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Trimmed ends</source>
   <translation>Éboutage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Turn</source>
   <translation>Tourner</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Twist</source>
   <translation>Torsion</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>U part</source>
   <translation>Part de u</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>Undo</source>
   <translation>Annuler</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Unduloid (Delaunay), mean curvature 1 / (widest + narrowest) as the mean of both principals.</source>
   <translation>Onduloïde (Delaunay), courbure moyenne 1 / (plus large + plus étroit), moyenne des deux principales.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structures.py" />
   <source>Update structures</source>
   <translation>Mettre à jour les structures</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>Use</source>
   <translation>Utiliser</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>Utilisation</source>
   <translation>Taux de travail</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>V part</source>
   <translation>Part de v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>Vertex</source>
   <translation>Sommet</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertex load</source>
   <translation>Charge de sommet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/editing.py" />
   <source>Vertex {} is fixed.</source>
   <translation>Le sommet {} est fixe.</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices that are nearer than this are merged</source>
   <translation>Les sommets plus proches que ceci sont fusionnés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Vertices, edges or faces keep the distance, or edges stay parallel</source>
   <translation>Sommets, arêtes ou faces gardent la distance, ou les arêtes restent parallèles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Waist</source>
   <translation>Taille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Web</source>
   <translation>Toile</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Weight of</source>
   <translation>Poids de</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Weight of 1 mm edge</source>
   <translation>Poids par mm d'arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Where lines u and v cross, in slots of one layer or about the bolts of two, they turn like this about their axis: rigid, hinged, or the stiffness of a spring in kNm/rad</source>
   <translation>Là où les lignes u et v se croisent, dans les entailles d'une couche ou autour des boulons de deux, elles tournent ainsi autour de leur axe : rigid, hinged ou la raideur d'un ressort en kNm/rad</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Which</source>
   <translation>Lequel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Widest</source>
   <translation>Le plus large</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Width</source>
   <translation>Largeur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>Width x height in pixels</source>
   <translation>Largeur x hauteur en pixels</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>Wind</source>
   <translation>Vent</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>Within</source>
   <translation>À moins de</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>Workers</source>
   <translation>Processus</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>Worst</source>
   <translation>Pire</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_view.py" />
   <source>Write files</source>
   <translation>Écrire les fichiers</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structures.py" />
   <source>Writing fabrication files</source>
   <translation>Écriture des fichiers de fabrication</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/structural_checks.py" />
   <source>Writing files of the check</source>
   <translation>Écriture des fichiers de la vérification</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a block for each part</source>
   <translation>un bloc par pièce</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a file for each part</source>
   <translation>un fichier par pièce</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a joint has so many bolts above each other</source>
   <translation>nombre de boulons superposés d'un assemblage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a length for each direction</source>
   <translation>une longueur par direction</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a patch is built up to this distortion of an edge</source>
   <translation>une surface est réalisée jusqu'à cette distorsion d'une arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a saw cut behind a piece is this wide</source>
   <translation>un trait de scie après une pièce a cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>a third layer lies along these diagonals, which brace the net</source>
   <translation>une troisième couche repose sur ces diagonales, qui contreventent le réseau</translation>
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
   <translation>au-dessus</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>all</source>
   <translation>toutes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along</source>
   <translation>le long</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along X (X)</source>
   <translation>selon X (X)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along Y (Y)</source>
   <translation>selon Y (Y)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along Z (Z)</source>
   <translation>selon Z (Z)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along curvature</source>
   <translation>le long de la courbure</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>along the normal (N)</source>
   <translation>selon la normale (N)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along the sheet</source>
   <translation>le long de la tôle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along u</source>
   <translation>suivant u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>along v</source>
   <translation>suivant v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>aluminium</source>
   <translation>aluminium</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>angles with bolts join strips where these end</source>
   <translation>des équerres boulonnées joignent les bandes à leurs bouts</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>another number begins another search for a dense nesting</source>
   <translation>un autre nombre commence une autre recherche d'imbrication dense</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>another number gives another layout of quads</source>
   <translation>un autre nombre donne une autre disposition des quadrilatères</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>arc</source>
   <translation>arc</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>arch</source>
   <translation>arc</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as few as can be found</source>
   <translation>aussi peu que possible</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as it starts</source>
   <translation>comme il commence</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as long as it takes</source>
   <translation>aussi longue qu'il faut</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as single strokes</source>
   <translation>en traits simples</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as solids too</source>
   <translation>aussi en solides</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as text</source>
   <translation>en texte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as the net has it</source>
   <translation>selon le réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>as thick as the bolts</source>
   <translation>épaisse comme les boulons</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asked too</source>
   <translation>inclus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>assemblies in IFC hold the parts of a system, of a line or of a ring</source>
   <translation>les ensembles dans IFC contiennent les pièces d'un système, d'une ligne ou d'un anneau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic</source>
   <translation>asymptotique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic-angle</source>
   <translation>asymptotic-angle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic: minimal</source>
   <translation>asymptotique : minimale</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>asymptotic: one angle</source>
   <translation>asymptotique : un angle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>auto</source>
   <translation>automatique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/fields.py" />
   <source>automatic</source>
   <translation>automatique</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>automatic: {}</source>
   <translation>automatique : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>ball</source>
   <translation>sphère</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars and strips are this long; longer lamellas are spliced</source>
   <translation>barres et bandes ont cette longueur ; les lamelles plus longues sont aboutées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars are listed with lengths and angles of both ends, and how to read them</source>
   <translation>les barres sont listées, avec longueurs et angles des deux bouts, et comment les lire</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars come in these lengths too, mm; the shortest that will do is taken</source>
   <translation>les barres existent aussi en ces longueurs, mm ; la plus courte qui suffit est prise</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bars lose this much at each end</source>
   <translation>les barres perdent autant à chaque bout</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>base plates and caps are this thick</source>
   <translation>épaisseur des platines de base et de tête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>beams</source>
   <translation>poutres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>beams are bolted with bolts of this size</source>
   <translation>les poutres sont boulonnées avec cette taille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>beams that are shorter than this at the border are left out</source>
   <translation>les poutres plus courtes au bord sont laissées de côté</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>below</source>
   <translation>en dessous</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bent sides in IFC are facets, or exact for programs that read those</source>
   <translation>les faces courbes en IFC sont des facettes, ou exactes pour les programmes qui les lisent</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bevel</source>
   <translation>biseauté</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bolted</source>
   <translation>boulonné</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bolted hubs have walls of this thickness</source>
   <translation>épaisseur de paroi des moyeux boulonnés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>bolts, gaskets and setting blocks are listed, or drawn as solids too</source>
   <translation>vis, joints et cales sont dans la liste, ou dessinés aussi comme solides</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>border vertices that turn by more than this are kept</source>
   <translation>les sommets du bord qui tournent de plus sont gardés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>border, u and v have their own</source>
   <translation>bord, u et v ont la leur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>both</source>
   <translation>les deux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>both families</source>
   <translation>les deux familles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>boundary</source>
   <translation>bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>boxes pack fast, outlines densely</source>
   <translation>les boîtes rangent vite, les contours serré</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by boxes (fast)</source>
   <translation>par boîtes (rapide)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by line</source>
   <translation>par ligne</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by outlines (dense)</source>
   <translation>par contours (dense)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by ring</source>
   <translation>par anneau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by system</source>
   <translation>par système</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>by the sampling</source>
   <translation>par l'échantillonnage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cables</source>
   <translation>câbles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>catenoid</source>
   <translation>caténoïde</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>catmull-clark</source>
   <translation>Catmull-Clark</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>centre</source>
   <translation>au centre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>chebyshev</source>
   <translation>Tchebychev</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>checkerboard</source>
   <translation>damier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>circular</source>
   <translation>circulaire</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cmc</source>
   <translation>CMC</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>coarsen</source>
   <translation>grossir</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cold</source>
   <translation>à froid</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>compression and tension</source>
   <translation>compression et traction</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>compression only</source>
   <translation>compression seule</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cone</source>
   <translation>cône</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>confocal-conics</source>
   <translation>coniques homofocales</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>conical</source>
   <translation>conique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>constant mean curvature</source>
   <translation>courbure moy. constante</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>coped-u</source>
   <translation>grugé à u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>coped-v</source>
   <translation>grugé à v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>corners</source>
   <translation>coins</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cover-plate</source>
   <translation>éclisse</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>creases between {} faces run at {:.0f} degrees to the lines of curvature on average: lines run along all creases and along the border, where the net ends, in place of curvature. A net along curvature, which has flat panels, is one on each face alone (--faces)</source>
   <translation>les arêtes entre {} faces font en moyenne {:.0f} degrés avec les lignes de courbure : les lignes suivent toutes les arêtes et le bord, où le réseau s'arrête, au lieu de la courbure. Un réseau le long de la courbure, aux panneaux plans, se fait sur chaque face seule (--faces)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>curvature</source>
   <translation>courbure</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cut</source>
   <translation>couper</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>cylinder</source>
   <translation>cylindre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>developable</source>
   <translation>développable</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>diagonal mesh</source>
   <translation>maillage diagonal</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>directions</source>
   <translation>directions</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>dog</source>
   <translation>géodésique orthogonal discret</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drawings are of this size</source>
   <translation>les dessins ont ce format</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drawings are of this version</source>
   <translation>les dessins sont de cette version</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drawings have this date in their title block</source>
   <translation>les dessins portent cette date dans leur cartouche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>drop</source>
   <translation>omettre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>each part has a file for machines that saw, drill and cut steel (DSTV)</source>
   <translation>chaque pièce a un fichier pour les machines qui scient, percent et coupent l'acier (DSTV)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>each part has a label with a QR code of its name</source>
   <translation>chaque pièce a une étiquette avec un code QR de son nom</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>edge</source>
   <translation>arête</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>edges</source>
   <translation>arêtes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>edges of metal panels are folded down by this</source>
   <translation>les bords des panneaux de tôle sont pliés vers le bas d'autant</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>ellipsoid</source>
   <translation>ellipsoïde</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>elliptic multi-net</source>
   <translation>multi-réseau elliptique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>elliptic-paraboloid</source>
   <translation>paraboloïde elliptique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>end-plate</source>
   <translation>platine</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>enneper</source>
   <translation>Enneper</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>exact</source>
   <translation>exactes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>exactly flat</source>
   <translation>exactement plan</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>face</source>
   <translation>face</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>faces</source>
   <translation>faces</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>faces flat to {}</source>
   <translation>faces planes à {} près</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>faces of this size leave the surface by {} between their corners: take a finer mesh, or allow as much</source>
   <translation>des faces de cette taille s'écartent de {} de la surface entre leurs coins : prenez un maillage plus fin, ou admettez autant</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>facets</source>
   <translation>facettes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>factor {:.2f}</source>
   <translation>facteur {:.2f}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>fill</source>
   <translation>remplir</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>first</source>
   <translation>premier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>folds have this radius inside, by default that of the thickness</source>
   <translation>rayon intérieur des plis, sinon celui de l'épaisseur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>folds keep the length of the fibre at this part of the thickness, 0: by DIN 6935</source>
   <translation>les plis gardent la longueur de la fibre à cette part de l'épaisseur ; 0 : selon DIN 6935</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>follow</source>
   <translation>suivre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>for about 600 faces</source>
   <translation>pour 600 faces environ</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>form-finding</source>
   <translation>recherche de forme</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>formulas</source>
   <translation>formules</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>four anchor bolts hold a base plate</source>
   <translation>quatre ancrages tiennent une platine</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>free</source>
   <translation>libre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>gaskets below and above framed panels are this thick</source>
   <translation>épaisseur des joints sous et sur les panneaux en cadre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic</source>
   <translation>géodésique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic and Chebyshev</source>
   <translation>géodésique et Tchebychev</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic, four equal angles</source>
   <translation>géodésique, angles égaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic-chebyshev</source>
   <translation>géodésique et Tchebychev</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>geodesic: developable</source>
   <translation>géodésique : développable</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>gfrp</source>
   <translation>PRV</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structural_panel.py" />
   <source>given here</source>
   <translation>donnés ici</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>given: {}</source>
   <translation>donnés : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>glTF holds all parts, with names and colours, for viewers</source>
   <translation>glTF contient toutes les pièces, avec noms et couleurs, pour les visionneuses</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>glass</source>
   <translation>verre</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>glide on {}</source>
   <translation>glisser sur {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>helicoid</source>
   <translation>hélicoïde</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>hollow</source>
   <translation>creux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>hollow sections and flanges are this wide</source>
   <translation>les profils creux et les semelles ont cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>hub</source>
   <translation>moyeu</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/forming.py" />
   <source>in equilibrium, unbalanced {:.0e}; largest support force {:.3g}</source>
   <translation>en équilibre, déséquilibre {:.0e} ; plus grande force d'appui {:.3g}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>in the list only</source>
   <translation>dans la liste seule</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>insulating-glass-4-12-4-12-4</source>
   <translation>vitrage 4/12/4/12/4</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>insulating-glass-6-16-6</source>
   <translation>vitrage 6/16/6</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>inversion</source>
   <translation>inversion</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/aligning.py" />
   <source>irregular: {}</source>
   <translation>irréguliers : {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isogonal</source>
   <translation>isogonal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isogonal: one angle</source>
   <translation>isogonal : un seul angle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isometric</source>
   <translation>isométrique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isometric: faces keep shape</source>
   <translation>isométrique : mêmes faces</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isothermic</source>
   <translation>isotherme</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>isothermic: has a dual</source>
   <translation>isotherme : a un dual</translation>
  </message>
  <message>
   <location filename="../../../solver/align/guides.py" />
   <source>it is made of flat faces that meet at creases: lines along these cannot run along all eaves as well; a net on each face alone (--faces) keeps to its longest side</source>
   <translation>elle est faite de faces planes qui se rejoignent à des plis : des lignes le long de ceux-ci ne peuvent pas suivre aussi toutes les rives ; un réseau sur chaque face seule (--faces) suit son plus long côté</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>its own boundary</source>
   <translation>son propre bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>join</source>
   <translation>joindre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>joints of structural silicone are this wide</source>
   <translation>largeur des joints de silicone structurel</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>labels are printed on this sheet: columns x rows, a4 or letter-3x10</source>
   <translation>les étiquettes sont imprimées sur cette planche : colonnes x rangées, A4 ou letter-3x10</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lambda</source>
   <translation>lambda</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lapped</source>
   <translation>à mi-bois</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>leave-out</source>
   <translation>omettre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>left out</source>
   <translation>exclus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>length</source>
   <translation>longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lift</source>
   <translation>relever</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>lines bunch near ({}): one edge in {} is shorter than {:.0f} % of what was wanted; try: singular vertices beside that place, or another net</source>
   <translation>des lignes se serrent près de ({}) : une arête sur {} est plus courte que {:.0f} % de ce qui était voulu ; essayer : des sommets singuliers à côté de cet endroit, ou un autre réseau</translation>
  </message>
  <message>
   <location filename="../../../solver/align/align.py" />
   <source>lines that follow the surface's own directions closely would run into each other, or bunch, here; these do less so</source>
   <translation>des lignes qui suivent de près les directions propres de la surface se rejoindraient ou se serreraient ici ; celles-ci le font moins</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>loop</source>
   <translation>boucle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>lying</source>
   <translation>couché</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>map</source>
   <translation>carte</translation>
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
   <translation>maillage médian</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>membrane</source>
   <translation>membrane</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>meshes</source>
   <translation>maillages</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>mirror</source>
   <translation>miroir</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>mitred</source>
   <translation>à onglet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>most of the surface bulges (positive Gauss curvature), and there it has no asymptotic lines</source>
   <translation>la surface est presque partout bombée (courbure de Gauss positive) et n'y a pas de lignes asymptotiques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>mu</source>
   <translation>mu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>multi-net</source>
   <translation>multi-réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>names and marks are written so</source>
   <translation>noms et marques sont écrits ainsi</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>near the net</source>
   <translation>près du réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>no</source>
   <translation>non</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>no beams are made along the boundary</source>
   <translation>aucune poutre n'est faite le long du bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>nodes</source>
   <translation>nœuds</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>none</source>
   <translation>aucun</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>not asked for</source>
   <translation>non demandé</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>not at all</source>
   <translation>pas du tout</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>not limited</source>
   <translation>sans limite</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>nothing</source>
   <translation>rien</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>nothing (on the net itself)</source>
   <translation>rien (le réseau)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>nu</source>
   <translation>nu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>offset</source>
   <translation>décalage</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>on the face diagonals</source>
   <translation>sur les diagonales</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>on the surface (S)</source>
   <translation>sur la surface (S)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one for all parts</source>
   <translation>un pour toutes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one for each system</source>
   <translation>un par système</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one layer</source>
   <translation>une couche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one layer has slots where strips cross, two have bolt holes</source>
   <translation>une couche a des encoches où les bandes se croisent, deux ont des trous de boulons</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/window/dialogs.py" />
   <source>one section for all</source>
   <translation>une section pour toutes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one workbook holds all lists, and masses with a column for prices</source>
   <translation>un classeur contient toutes les listes, et les masses avec une colonne pour les prix</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one, in place</source>
   <translation>un, en place</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>one-sheeted hyperboloid</source>
   <translation>hyperboloïde à une nappe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>orient</source>
   <translation>orienter</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>orthogonal</source>
   <translation>orthogonal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>outlines grow by half this width of a cut</source>
   <translation>les contours croissent de la moitié du trait de coupe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>panels</source>
   <translation>panneaux</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>panels are flat and their corners right as they are: no exact net moves them</source>
   <translation>les panneaux sont déjà plans et leurs coins droits : aucun réseau exact ne les déplace</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>panels are flat as they are, and stay so in a planar net (--net planar); creases are askew to each other, so that corners are not right, and an exact principal net leaves the roof</source>
   <translation>les panneaux sont déjà plans et le restent dans un réseau plan (--net planar) ; les arêtes sont obliques entre elles, si bien que les coins ne sont pas droits, et un réseau principal exact quitte le toit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>panels reach this far under pressure plates, by default 15 mm or as glass needs</source>
   <translation>prise des panneaux sous les serreurs, par défaut 15 mm ou selon le besoin du verre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parallel</source>
   <translation>parallèle</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>parallel to the screen (V)</source>
   <translation>parallèle à l'écran (V)</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parameter</source>
   <translation>paramètre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts are blocks, plain lines or files</source>
   <translation>les pièces sont des blocs, de simples lignes ou des fichiers</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts are nested on sheets of this size</source>
   <translation>les pièces sont imbriquées sur des plaques de cette taille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts in 3DM are meshes, or solids where their sides are plane</source>
   <translation>les pièces en 3DM sont des maillages, ou des solides si leurs faces sont planes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts keep so far from each other and from the rim</source>
   <translation>distance entre les pièces et jusqu'au bord</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts may turn</source>
   <translation>rotation libre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts may turn on the sheet as its grain says</source>
   <translation>les pièces tournent sur la plaque selon le sens du fil</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>parts that agree within this are equal: one drawing, with how many are cut from it</source>
   <translation>les pièces qui concordent à cela près sont égales : un dessin, avec leur nombre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pieces of panels at the border that are narrower than this are slivers</source>
   <translation>les morceaux de panneaux plus étroits au bord sont des chutes</translation>
  </message>
  <message>
   <location filename="../../../solver/align/prepare.py" />
   <source>pinholes are closed: {}, {} across at most</source>
   <translation>petits trous fermés : {}, larges de {} au plus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plain</source>
   <translation>uni</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plain lines</source>
   <translation>simples lignes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plan, sheets, a typical node and typical parts are drawn with dimensions, to scale</source>
   <translation>plan, tôles, un nœud type et des pièces types sont dessinés avec cotes, à l'échelle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>planar</source>
   <translation>plan</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>planar-lines</source>
   <translation>planar-lines</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>planar: flat faces</source>
   <translation>plan : faces planes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plane lines: flat beams</source>
   <translation>lignes planes : arcs plats</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plate</source>
   <translation>plat</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plates of this family run through where two cross, both by half laps</source>
   <translation>les plaques de cette famille passent là où deux se croisent, les deux à mi-bois</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>plywood</source>
   <translation>contreplaqué</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pressure plates and caps are this wide, by default 50 mm or as wide as glass needs</source>
   <translation>largeur des serreurs et capots, par défaut 50 mm ou selon le besoin du verre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pressure plates and caps hold the panels, or structural silicone on adapters</source>
   <translation>serreurs et capots tiennent les panneaux, ou du silicone structurel sur adaptateurs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>principal</source>
   <translation>principal</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>principal stress: equilibrium</source>
   <translation>contraintes principales</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>principal: flat panels</source>
   <translation>principal : panneaux plans</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pseudo-geodesic</source>
   <translation>pseudo-geodesic</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>pseudo-geodesic: tilted</source>
   <translation>pseudo-géodésique : incliné</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>quads</source>
   <translation>quadrilatères</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>quads have edges about this long</source>
   <translation>les arêtes des quadrilatères ont à peu près cette longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>quarter</source>
   <translation>quart</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/display_panel.py" />
   <source>range: give both numbers, or none for an automatic range</source>
   <translation>plage : donner les deux nombres, ou aucun pour une plage automatique</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rectangle</source>
   <translation>rectangle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rests of bars from this length on are kept</source>
   <translation>les restes de barres sont gardés à partir de cette longueur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>ring</source>
   <translation>anneau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rotational</source>
   <translation>de révolution</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>round</source>
   <translation>rond</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>rows are cut along lines of the net into pieces of at most this length</source>
   <translation>les rangées sont coupées aux lignes du réseau en pièces de cette longueur au plus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>scherk</source>
   <translation>Scherk</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>second</source>
   <translation>second</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>sharp corners</source>
   <translation>coins vifs</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>sheets come in these sizes too, mm; the smallest that will do is taken</source>
   <translation>les tôles existent aussi en ces formats, mm ; le plus petit qui suffit est pris</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>silicone</source>
   <translation>silicone</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>slivers at the border become part of their neighbours where they can, or are left out</source>
   <translation>les chutes au bord rejoignent leurs voisines si possible, ou sont omises</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>slots and hubs leave this much air</source>
   <translation>les encoches et les moyeux laissent ce jeu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>slots have round corners for a milling cutter of this diameter</source>
   <translation>les fentes ont des coins ronds pour une fraise de ce diamètre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>snap</source>
   <translation>ajuster</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>snet</source>
   <translation>S-réseau</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>socket</source>
   <translation>douille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids</source>
   <translation>solides</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids have the rounded corners and roots of a section of the catalogue</source>
   <translation>les solides ont les coins et congés arrondis d'une section du catalogue</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids share a file, have one a system, or lie in one without places</source>
   <translation>les solides partagent un fichier, en ont un par système, ou sont dans un seul sans placements</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>solids that agree within this are one product of the file with several places</source>
   <translation>les solides égaux à cela près sont un seul produit du fichier en plusieurs places</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>sphere</source>
   <translation>sphère</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spherical stars</source>
   <translation>étoiles sphériques</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spliced beams have a splice after so many nodes, 0 for none</source>
   <translation>les poutres éclissées ont un joint après autant de nœuds, 0 pour aucun</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spliced-u</source>
   <translation>éclissé-u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>spliced-v</source>
   <translation>éclissé-v</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>square</source>
   <translation>d'équerre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>stainless</source>
   <translation>inox</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>standing</source>
   <translation>debout</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>star</source>
   <translation>étoile</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>stay near {}</source>
   <translation>rester près de {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>steel</source>
   <translation>acier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>straight</source>
   <translation>droit</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>strengthened-glass</source>
   <translation>verre durci</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>stress</source>
   <translation>contrainte</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>strip</source>
   <translation>bande</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>strips are cut from this length; longer ones are spliced</source>
   <translation>les bandes sont coupées dans cette longueur ; les plus longues sont éclissées</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>stroke {} runs at {:.0f} degrees to the lines of a {} net on average: the net follows it, but an exact one near to this surface does not; draw it along these lines, or leave the net as it is aligned</source>
   <translation>la courbe {} fait en moyenne {:.0f} degrés avec les lignes d'un réseau {} : le réseau la suit, mais pas un réseau exact près de cette surface ; la dessiner le long de ces lignes, ou laisser le réseau tel qu'il est aligné</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>subdivide</source>
   <translation>subdiviser</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/aligned_panel.py" />
   <source>surface</source>
   <translation>surface</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/multinets.py" />
   <source>t from {} to {}, admissible from {} on</source>
   <translation>t de {} à {}, admissible à partir de {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/multinets.py" />
   <source>t from {} to {}, admissible from {} to {}</source>
   <translation>t de {} à {}, admissible de {} à {}</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tangent-developable</source>
   <translation>développable de tangentes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tension only</source>
   <translation>traction seule</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the axes unroll to lines of this kind</source>
   <translation>les axes se déroulent en lignes de ce type</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the base plates lie this far below the vertices</source>
   <translation>distance des platines sous les sommets</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams are joined by hubs or sockets</source>
   <translation>les poutres sont reliées par des moyeux ou des douilles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams are this high</source>
   <translation>les poutres ont cette hauteur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams have this cross section, or one of the catalogue such as HEB160</source>
   <translation>les poutres ont cette section, ou une du catalogue comme HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the beams meet like this at a node</source>
   <translation>les poutres se joignent ainsi à un nœud</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the bolt holes have this diameter</source>
   <translation>les trous de boulons ont ce diamètre</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>the border runs at {:.0f} degrees to the lines of curvature on average: an exact principal net leaves it; a planar one with some millimetres of flatness, which glides along its boundary, keeps it</source>
   <translation>le bord fait en moyenne {:.0f} degrés avec les lignes de courbure : un réseau principal exact le quitte ; un réseau plan avec quelques millimètres de planéité, qui glisse le long de son bord, le garde</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the border that is held twists the surface by {:.1f} degrees between the vertices {} and {}, where this net allows hardly any: let the border leave its curve and trim it afterwards</source>
   <translation>le bord tenu tord la surface de {:.1f} degrés entre les sommets {} et {}, là où ce réseau n'en admet guère : laisser le bord quitter sa courbe et le rogner ensuite</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the edge beam has this cross section, or one of the catalogue such as HEB160</source>
   <translation>la poutre de rive a cette section, ou une du catalogue comme HEB160</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the edge beam is this high, by default as high as the beams</source>
   <translation>hauteur de la poutre de rive, sinon celle des poutres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the edge beam is this wide, by default as thick as the plates or 60 mm</source>
   <translation>largeur de la poutre de rive, sinon l'épaisseur des plaques ou 60 mm</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the family nearer to it</source>
   <translation>la famille la plus proche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the flanges are this thick, by default as thick as the plates</source>
   <translation>les semelles ont cette épaisseur, par défaut celle des plats</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the hubs have a hole of this diameter along their axis</source>
   <translation>les moyeux ont un trou de ce diamètre le long de leur axe</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the hubs measure this across their faces</source>
   <translation>les moyeux mesurent autant entre leurs faces</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the joint between two panels is this wide</source>
   <translation>le joint entre deux panneaux a cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the joint between two patches is this wide</source>
   <translation>le joint entre deux surfaces a cette largeur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>the level of its lowest vertex</source>
   <translation>le niveau de son sommet le plus bas</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the library may take so many seconds</source>
   <translation>la bibliothèque peut prendre tant de secondes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the lines bend with the surface, where this net asks for asymptotic lines: begin with a net along curvature with lines for asymptotic-angle, near to the surface</source>
   <translation>les lignes se courbent avec la surface, alors que ce réseau demande des lignes asymptotiques : commencer par un réseau selon la courbure avec des lignes pour asymptotic-angle, près de la surface</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the lines do not follow the curvature of the surface, as this net has to, but those of its diagonal mesh do: make a diagonal mesh first</source>
   <translation>les lignes ne suivent pas la courbure de la surface, comme ce réseau le doit, mais celles de son maillage diagonal la suivent : faire d'abord un maillage diagonal</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the lines do not follow the curvature of the surface, as this net has to: take a start whose lines do</source>
   <translation>les lignes ne suivent pas la courbure de la surface, comme ce réseau le doit : prendre un départ dont les lignes la suivent</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the louvres are turned by this angle about their lines</source>
   <translation>les brise-soleil sont tournés de cet angle autour de leurs lignes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the louvres turn about lines of this family</source>
   <translation>les brise-soleil tournent autour des lignes de cette famille</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the model's origin is there on site, in metres</source>
   <translation>l'origine du modèle est là sur le site, en mètres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the model's x axis is turned so far from east</source>
   <translation>l'axe x du modèle est tourné d'autant depuis l'est</translation>
  </message>
  <message>
   <location filename="../../../solver/align/symmetry.py" />
   <source>the net is symmetric in {}</source>
   <translation>le réseau est symétrique par rapport à {}</translation>
  </message>
  <message>
   <location filename="../../../solver/align/remarks.py" />
   <source>the opening at {}, {} across, is too small for faces of this size: lines run over it; a shorter edge keeps it</source>
   <translation>l'ouverture en {}, large de {}, est trop petite pour des faces de cette taille : des lignes passent dessus ; une arête plus courte la garde</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the other variant of this net, on or off the diagonals, is much nearer</source>
   <translation>l'autre variante de ce réseau, sur les diagonales ou non, est bien plus proche</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the panels are flat, or bent cold into faces that are not planar</source>
   <translation>les panneaux sont plans, ou cintrés à froid dans des faces non planes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the panels are this thick, by default as thick as the plates</source>
   <translation>les panneaux ont cette épaisseur, par défaut celle des plats</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the panels' corners are cut off beside hubs, or the panels lifted over them</source>
   <translation>près des moyeux, les coins des panneaux sont coupés, ou les panneaux relevés par-dessus</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the parts lie above the net, about it or below it</source>
   <translation>les pièces se trouvent au-dessus du réseau, autour de lui ou en dessous</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the plates are this thick</source>
   <translation>les plats ont cette épaisseur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the plates stand this deep in the sockets</source>
   <translation>les plats entrent de cette profondeur dans les douilles</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the posts are round tubes of this diameter</source>
   <translation>les poteaux sont des tubes ronds de ce diamètre</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the profile's own</source>
   <translation>celui du profil</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the saw cut behind each part of a bar is this wide</source>
   <translation>le trait de scie derrière chaque pièce d'une barre a cette largeur</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the shape is doubly curved and will be bent towards a developable surface</source>
   <translation>la forme est à double courbure et sera pliée vers une surface développable</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the sides of the panels are square, or bevelled along the beams</source>
   <translation>les chants des panneaux sont d'équerre, ou biseautés le long des poutres</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the solids are smooth instead of faceted</source>
   <translation>les solides sont lisses au lieu de facettés</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the stock loses this much at each end</source>
   <translation>la longueur en stock perd autant à chaque bout</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips are made of plane faces or twisted</source>
   <translation>les bandes sont faites de faces planes ou tordues</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips are this wide</source>
   <translation>les bandes ont cette largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips end square before the border, or along it</source>
   <translation>les bandes finissent d'équerre avant le bord, ou le long de lui</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips go this far beyond their last vertex, by default half their width</source>
   <translation>les bandes dépassent d'autant leur dernier sommet, par défaut de la moitié de leur largeur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the strips stand on the surface, lie in it, or tilt as the net wants it</source>
   <translation>les bandes sont debout sur la surface, couchées, ou inclinées comme le veut le réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_words.py" />
   <source>the surface has asymptotic lines, as this net asks for, only where it bends both ways: take one that is a saddle all over, or another net</source>
   <translation>la surface n'a de lignes asymptotiques, comme ce réseau en demande, que là où elle se courbe dans les deux sens : en prendre une qui soit partout une selle, ou un autre réseau</translation>
  </message>
  <message>
   <location filename="../../../solver/align/symmetry.py" />
   <source>the surface has no plane of symmetry; the net is made without</source>
   <translation>la surface n'a pas de plan de symétrie ; le réseau est fait sans</translation>
  </message>
  <message>
   <location filename="../../../solver/align/guides.py" />
   <source>the surface is flat or round: every direction is one of curvature; the lines run along its border</source>
   <translation>la surface est plane ou ronde : toute direction est une direction de courbure ; les lignes suivent son bord</translation>
  </message>
  <message>
   <location filename="../../../solver/align/patches.py" />
   <source>the surface is made of {} flat faces: lines run along all creases between them and along the border, where the net ends</source>
   <translation>la surface est faite de {} faces planes : les lignes suivent toutes les arêtes entre elles et le bord, où le réseau s'arrête</translation>
  </message>
  <message>
   <location filename="../../../solver/align/prepare.py" />
   <source>the surface is rough, by {} within an edge; the net is on a smooth one through it</source>
   <translation>la surface est rugueuse, de {} sur une arête ; le réseau est sur une surface lisse passant par elle</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the walls of a tube along the edge are this thick</source>
   <translation>épaisseur des parois d'un tube de rive</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>the walls of the posts are this thick</source>
   <translation>épaisseur des parois des poteaux</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>these lists have order of assembly, weights, what meets at nodes, points to be surveyed</source>
   <translation>ces listes ont l'ordre de montage, les poids, ce qui se rencontre aux nœuds, les points à relever</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>these rows of item, unit and price give the lists' costs</source>
   <translation>ces lignes de poste, unité et prix donnent les coûts des listes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>these vertices stand on feet: corners, boundary, or their numbers as 0,12,40</source>
   <translation>ces sommets posent sur des pieds : corners, boundary ou leurs numéros comme 0,12,40</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>those of its file</source>
   <translation>celles de son fichier</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>through</source>
   <translation>continu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>through-u</source>
   <translation>u traversant</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>through-v</source>
   <translation>v traversant</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tilted</source>
   <translation>inclinées</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>timber</source>
   <translation>bois</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>toughened-glass</source>
   <translation>verre trempé</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>transform</source>
   <translation>transformer</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>translational</source>
   <translation>de translation</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>trim</source>
   <translation>rogner</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tube</source>
   <translation>tube</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>tubes of one section differ so much in height</source>
   <translation>les tubes d'une section diffèrent d'autant en hauteur</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>twisted</source>
   <translation>tordu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>two-sheeted hyperboloid</source>
   <translation>hyperboloïde à deux nappes</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>u</source>
   <translation>u</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>u lines</source>
   <translation>lignes u</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>unduloid</source>
   <translation>onduloïde</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>v</source>
   <translation>v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/structure_panel.py" />
   <source>v lines</source>
   <translation>lignes v</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>vertex</source>
   <translation>sommet</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/constraint_box.py" />
   <source>vertex {} drawn to its place</source>
   <translation>sommet {} attiré vers son lieu</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>wave</source>
   <translation>onde</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>web</source>
   <translation>web</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>web: three layers of slats</source>
   <translation>toile : trois couches</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>weld</source>
   <translation>souder</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>whole rows</source>
   <translation>rangées entières</translation>
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
   <translation>oui</translation>
  </message>
  <message>
   <location filename="../../../scripts/catalogue_words.py" />
   <source>z</source>
   <translation>z</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{:,} vertices, {:,} faces</source>
   <translation>{:,} sommets, {:,} faces</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{:,} vertices, {:,} variables, {:,} constraints, {} a step</source>
   <translation>{:,} sommets, {:,} inconnues, {:,} contraintes, {} par pas</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>{:.0f} a second</source>
   <translation>{:.0f} par seconde</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/view/check_shapes.py" />
   <source>{:.3g} to {:.3g} kN</source>
   <translation>{:.3g} à {:.3g} kN</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>{} (baked)</source>
   <translation>{} (figé)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/installer.py" />
   <source>{} cannot be started.</source>
   <translation>{} ne peut pas être démarré.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/stroke_box.py" />
   <source>{} drawn</source>
   <translation>{} dessinées</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>{} edges</source>
   <translation>{} arêtes</translation>
  </message>
  <message>
   <location filename="../../../solver/align/align.py" />
   <source>{} faces are folded; give a shorter edge, or smooth the surface there</source>
   <translation>{} faces sont repliées ; donner une arête plus courte ou lisser la surface à cet endroit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/display.py" />
   <source>{} is hidden: nothing of this is seen yet</source>
   <translation>{} est masqué : rien de ceci n'est encore visible</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>{} is outdated: its source has changed since it was optimised or dragged</source>
   <translation>{} est périmé : sa source a changé depuis qu'il a été optimisé ou tiré</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{} kinds of edges within {}, {} before.</source>
   <translation>{} types d'arêtes à {} près, {} avant.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{} kinds of nodes within {}, {} before.</source>
   <translation>{} types de nœuds à {} près, {} avant.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/optimise_panel.py" />
   <source>{} kinds of panels within {}, {} before.</source>
   <translation>{} types de panneaux à {} près, {} avant.</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>{} lines</source>
   <translation>{} lignes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/baking.py" />
   <source>{} mesh</source>
   <translation>{} maillage</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>{} of them exceed a limit, such as {}: {}</source>
   <translation>{} d'entre elles dépassent une limite, par exemple {} : {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/edit_panel.py" />
   <source>{} of {} chosen</source>
   <translation>{} sur {} choisis</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/workshop_panels.py" />
   <source>{} of {} parts exceed a limit, see report.html</source>
   <translation>{} pièces sur {} dépassent une limite, voir report.html</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/net_choice.py" />
   <source>{} on the diagonals</source>
   <translation>{} sur les diagonales</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/drawing_pages.py" />
   <source>{} parts, {} to {}</source>
   <translation>{} pièces, {} à {}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/multi_net_panel.py" />
   <source>{} points</source>
   <translation>{} points</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/mirror.py" />
   <source>{} separate components</source>
   <translation>{} parties séparées</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{} separate parts: not all faces meet along whole sides</source>
   <translation>{} parties séparées : toutes les faces ne se rejoignent pas le long de côtés entiers</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/source_net.py" />
   <source>{} stays as it is, though its source has changed: optimise it again</source>
   <translation>{} reste tel quel, bien que sa source ait changé : l'optimiser à nouveau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/residual_plot.py" />
   <source>{} steps</source>
   <translation>{} pas</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{} vertices lie beside a seam and could not be joined</source>
   <translation>{} sommets sont à côté d'une couture et n'ont pas pu être joints</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/mirror.py" />
   <source>{} vertices merged</source>
   <translation>{} sommets fusionnés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/sources/aligning.py" />
   <source>{} vertices with {} lines</source>
   <translation>{} sommets à {} lignes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/source_panel.py" />
   <source>{} vertices, {} quads</source>
   <translation>{} sommets, {} quadrilatères</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/outdated.py" />
   <source>{} waits to be built anew: Refresh or Update structures does it</source>
   <translation>{} attend d'être reconstruit : par Rafraîchir ou Mettre à jour les structures</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/singular_box.py" />
   <source>{} with {} lines</source>
   <translation>{} à {} lignes</translation>
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
   <translation>{} : loin de l'origine ; placé près d'elle, et remis en place à l'export
</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/objects/structure.py" />
   <source>{}: {:,} parts, {:,.1f} kg</source>
   <translation>{} : {:,} pièces, {:,.1f} kg</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{}: {} quads at the border had no room and were left out</source>
   <translation>{} : {} quadrilatères au bord n'avaient pas la place et ont été omis</translation>
  </message>
  <message>
   <location filename="../../../solver/mesh/sampling.py" />
   <source>{}: {} quads at the border have a straight corner</source>
   <translation>{} : {} quadrilatères au bord ont un coin plat</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>{}: {} vertices, {} faces of {} corners, edge ratio {:.2f}</source>
   <translation>{} : {} sommets, {} faces à {} coins, rapport d’arêtes {:.2f}</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/panels/check_panel.py" />
   <source>{}: {} vertices, {} quads, {} irregular, edge ratio {:.2f}</source>
   <translation>{} : {} sommets, {} quadrilatères, {} irréguliers, rapport d'arêtes {:.2f}</translation>
  </message>
 </context>
 <context>
  <name>OrthoPreferences</name>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Ask once a session, when the workbench is opened</source>
   <translation>Demander une fois par session, à l'ouverture de l'atelier</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Axis that points up</source>
   <translation>Axe vers le haut</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Beams</source>
   <translation>Poutres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colour of new beams</source>
   <translation>Couleur des nouvelles poutres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colour of new panels</source>
   <translation>Couleur des nouveaux panneaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colour of the faces of a net where no colour map is shown</source>
   <translation>Couleur des faces d'un réseau sans carte de couleurs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Colours of new objects</source>
   <translation>Couleurs des nouveaux objets</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Fabrication files</source>
   <translation>Fichiers de fabrication</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Follow at once up to</source>
   <translation>Suivre aussitôt jusqu'à</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Gap between panels</source>
   <translation>Joint entre panneaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>General</source>
   <translation>Général</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Height of beams</source>
   <translation>Hauteur des poutres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Height of new beams, along the axes</source>
   <translation>Hauteur des nouvelles poutres, le long des axes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Import</source>
   <translation>Importation</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Nets</source>
   <translation>Réseaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Offer to install missing Python packages</source>
   <translation>Proposer d'installer les paquets Python manquants</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Optimisation</source>
   <translation>Optimisation</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Packages</source>
   <translation>Paquets</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Panels</source>
   <translation>Panneaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Processes that share the work on parts; worth it from some hundred parts on</source>
   <translation>Processus qui se partagent le travail sur les pièces ; utile à partir de quelques centaines de pièces</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Sizes that panels start with</source>
   <translation>Dimensions par défaut des panneaux de saisie</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Sparse solver</source>
   <translation>Solveur creux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Structures and flat patterns</source>
   <translation>Structures et développés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of beams</source>
   <translation>Épaisseur des poutres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of new panels</source>
   <translation>Épaisseur des nouveaux panneaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of panels</source>
   <translation>Épaisseur des panneaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Thickness of the plates of new beams</source>
   <translation>Épaisseur des plats des nouvelles poutres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Those that take longer to build keep their shape and a mark when their net changes, until Refresh or Update structures</source>
   <translation>Ce qui est plus long à construire garde sa forme et une marque quand le réseau change, jusqu'à Rafraîchir ou Mettre à jour les structures</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Unit of imported meshes</source>
   <translation>Unité des maillages importés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>What solves the linear system of each step; rslab is the faster one, where it is installed</source>
   <translation>Ce qui résout le système linéaire de chaque pas ; rslab est le plus rapide, s'il est installé</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Which axis of a mesh file points up; y is turned to FreeCAD's z</source>
   <translation>Quel axe d'un fichier de maillage pointe vers le haut ; y est tourné vers le z de FreeCAD</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Which unit the numbers of a mesh file are in</source>
   <translation>Dans quelle unité sont les nombres d'un fichier de maillage</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Width of the joint between neighbouring panels</source>
   <translation>Largeur du joint entre panneaux voisins</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>Workers</source>
   <translation>Processus</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>as the file says, else mm</source>
   <translation>comme le dit le fichier, sinon mm</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/resources/preferences.ui" />
   <source>the fastest installed</source>
   <translation>le plus rapide installé</translation>
  </message>
 </context>
 <context>
  <name>Ortho_AlignedNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A net on the selected CAD faces along the lines that an exact net has there, which overhangs their border; edges, wires and sketches that are selected too it runs along</source>
   <translation>Un réseau sur les faces CAO choisies, le long des lignes qu'un réseau exact y a ; il dépasse leur bord ; il court le long des arêtes, fils et esquisses choisis aussi</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Aligned net</source>
   <translation>Réseau aligné</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Net along curvature</source>
   <translation>Réseau selon la courbure</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Arches</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Arches</source>
   <translation>Arcs</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a plate that is cut flat along every line of the selected net that lies in a plane</source>
   <translation>Placer une plaque découpée à plat le long de chaque ligne du réseau choisi qui est dans un plan</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Bake</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Bake to plain features</source>
   <translation>Figer en objets simples</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Copy the selected nets and structures as Part features and meshes that need no add-on</source>
   <translation>Copier les réseaux et structures sélectionnés en objets Part et maillages qui n'ont besoin d'aucune extension</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Beams</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Beams</source>
   <translation>Poutres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put torsion-free beams on the edges or parameter lines of the selected net</source>
   <translation>Mettre des poutres sans torsion sur les arêtes ou lignes paramétriques du réseau sélectionné</translation>
  </message>
 </context>
 <context>
  <name>Ortho_BentPanels</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Bent panels</source>
   <translation>Panneaux pliés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put one bent plate in every row of faces of the selected net</source>
   <translation>Mettre une plaque pliée dans chaque rangée de faces du réseau sélectionné</translation>
  </message>
 </context>
 <context>
  <name>Ortho_ChangeNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>Derive, subdivide, transform or weld nets into a new one that follows</source>
   <translation>Dériver, subdiviser, transformer ou souder des réseaux en un nouveau qui suit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>Net from nets</source>
   <translation>Réseau à partir de réseaux</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Check</name>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Check</source>
   <translation>Vérifier</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Measure the selected net and say which kinds of nets it is near to</source>
   <translation>Mesurer le réseau sélectionné et dire de quels types de réseaux il est proche</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Derived</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Derived mesh</source>
   <translation>Maillage dérivé</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>The diagonal, medial or checkerboard mesh of the selected net, or its Christoffel dual</source>
   <translation>Le maillage diagonal, médian ou en damier du réseau choisi, ou son dual de Christoffel</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Display</name>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Choose the colour map and the overlays of the selected net</source>
   <translation>Choisir la carte de couleurs et les superpositions du réseau sélectionné</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Display</source>
   <translation>Affichage</translation>
  </message>
 </context>
 <context>
  <name>Ortho_DrawingPage</name>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Drawing page</source>
   <translation>Page de dessin</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Show each sheet of the selected flat patterns on a page to print</source>
   <translation>Montrer chaque tôle des développés sélectionnés sur une page à imprimer</translation>
  </message>
 </context>
 <context>
  <name>Ortho_EdgeBeam</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Edge beam</source>
   <translation>Poutre de rive</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a beam along the border of the selected net, at which beams and panels end</source>
   <translation>Poser une poutre le long du bord du réseau choisi, où s'arrêtent poutres et panneaux</translation>
  </message>
 </context>
 <context>
  <name>Ortho_EditNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Drag vertices of the selected net; the others follow so that it stays its kind of net</source>
   <translation>Tirer des sommets du réseau sélectionné ; les autres suivent pour qu'il reste de son type</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Edit net</source>
   <translation>Éditer le réseau</translation>
  </message>
 </context>
 <context>
  <name>Ortho_EllipticNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>An orthogonal multi-net from a curve in elliptic coordinates</source>
   <translation>Un multi-réseau orthogonal à partir d'une courbe en coordonnées elliptiques</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Elliptic multi-net</source>
   <translation>Multi-réseau elliptique</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Examples</name>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>A canopy made orthogonal and planar, with flat beams and panels</source>
   <translation>Un auvent rendu orthogonal et plan, avec des poutres et des panneaux plans</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>A form-found dome, then flat panels that meet at right angles</source>
   <translation>Une coupole issue de la recherche de forme, puis des panneaux plans qui se joignent à angle droit</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>A soap film and an asymptotic net on it: laths that unroll straight</source>
   <translation>Un film de savon et un réseau asymptotique dessus : des lattes qui se déroulent droites</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Developable sheets</source>
   <translation>Feuilles développables</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Four nets that are orthogonal exactly, in all their rectangles</source>
   <translation>Quatre réseaux exactement orthogonaux, dans tous leurs rectangles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Hanging net turned over</source>
   <translation>Réseau suspendu retourné</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Minimal gridshell</source>
   <translation>Résille minimale</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>One curved sheet made developable in two ways, corners held</source>
   <translation>Une feuille courbe rendue développable de deux façons, coins tenus</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Orthogonal multi-nets</source>
   <translation>Multi-réseaux orthogonaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/documents/examples.py" />
   <source>Roof of beams and panels</source>
   <translation>Toit de poutres et de panneaux</translation>
  </message>
 </context>
 <context>
  <name>Ortho_ExportFabrication</name>
  <message>
   <location filename="../../../freecad_ortho/commands/export_fabrication.py" />
   <source>Export fabrication files</source>
   <translation>Exporter les fichiers de fabrication</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/export_fabrication.py" />
   <source>Write solids (STEP), flat patterns and sheets (DXF), lists (CSV) and reports of the selected structures</source>
   <translation>Écrire les solides (STEP), développés et tôles (DXF), listes (CSV) et rapports des structures sélectionnées</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FaceNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Net on faces</source>
   <translation>Réseau sur des faces</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Sample the selected CAD faces along their parameter lines, joined where they meet</source>
   <translation>Échantillonner les faces CAO sélectionnées le long de leurs lignes paramétriques, réunies où elles se touchent</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Feet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put corners, the boundary or some vertices of the selected net on posts with base plates</source>
   <translation>Poser les coins, le bord ou des sommets du réseau choisi sur des poteaux à platine</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Support feet</source>
   <translation>Pieds d'appui</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FlatPatterns</name>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Flat patterns</source>
   <translation>Développés</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/flat_patterns.py" />
   <source>Lay the parts of the selected structures flat, in rows or on sheets</source>
   <translation>Mettre à plat les pièces des structures sélectionnées, en rangées ou sur des tôles</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FlipNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Flip net</source>
   <translation>Retourner le réseau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Turn the other side of the selected net up; an arrow shows it, offsets and parts follow</source>
   <translation>Tourner l'autre côté du réseau sélectionné vers le haut ; une flèche le montre, décalages et pièces suivent</translation>
  </message>
 </context>
 <context>
  <name>Ortho_FormNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A membrane or cable net in equilibrium that starts from the selected net</source>
   <translation>Une membrane ou un réseau de câbles en équilibre, à partir du réseau sélectionné</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Form-finding</source>
   <translation>Recherche de forme</translation>
  </message>
 </context>
 <context>
  <name>Ortho_ImportNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/import_net.py" />
   <source>Import quad mesh</source>
   <translation>Importer un maillage de quadrilatères</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/import_net.py" />
   <source>Read an OBJ, PLY, OFF, JSON or VTK file and keep its quads as a net</source>
   <translation>Lire un fichier OBJ, PLY, OFF, JSON ou VTK et garder ses quadrilatères comme réseau</translation>
  </message>
 </context>
 <context>
  <name>Ortho_InstallPackages</name>
  <message>
   <location filename="../../../freecad_ortho/commands/install_packages.py" />
   <source>Install missing packages</source>
   <translation>Installer les paquets manquants</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/install_packages.py" />
   <source>Install the Python packages that the workbench needs and FreeCAD does not find</source>
   <translation>Installer les paquets Python dont l'atelier a besoin et que FreeCAD ne trouve pas</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Lamellas</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Lamellas</source>
   <translation>Lamelles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a strip that unrolls flat along every parameter line of the selected net</source>
   <translation>Mettre le long de chaque ligne paramétrique du réseau sélectionné une bande qui se déroule à plat</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Louvres</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Louvres</source>
   <translation>Brise-soleil</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a slat on the midpoints of every face of the selected net</source>
   <translation>Mettre une lame sur les milieux de chaque face du réseau sélectionné</translation>
  </message>
 </context>
 <context>
  <name>Ortho_MultiNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Draw a polyline on a quadric; the orthogonal multi-net that it determines follows at once</source>
   <translation>Dessiner une polyligne sur une quadrique ; le multi-réseau orthogonal qu'elle détermine suit aussitôt</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Multi-net</source>
   <translation>Multi-réseau</translation>
  </message>
 </context>
 <context>
  <name>Ortho_NewNet</name>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>A net from numbers, CAD faces, triangles or form-finding</source>
   <translation>Un réseau à partir de nombres, de faces CAO, de triangles ou d'une recherche de forme</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/groups.py" />
   <source>New net</source>
   <translation>Nouveau réseau</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Nodes</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Nodes</source>
   <translation>Nœuds</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a hub or a joint at the vertices of the selected net</source>
   <translation>Mettre un moyeu ou un assemblage aux sommets du réseau sélectionné</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Offset</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A parallel net at an even distance</source>
   <translation>Un réseau parallèle à distance régulière</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Offset</source>
   <translation>Décalage</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Optimise</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Move the vertices of the selected net until its faces are orthogonal and planar</source>
   <translation>Déplacer les sommets du réseau sélectionné jusqu'à ce que ses faces soient orthogonales et planes</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Optimise</source>
   <translation>Optimiser</translation>
  </message>
 </context>
 <context>
  <name>Ortho_OptimiseAgain</name>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Optimise again</source>
   <translation>Optimiser de nouveau</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/optimise.py" />
   <source>Optimise the selected nets, or all, as before where their sources have changed since</source>
   <translation>Optimiser comme avant les réseaux choisis, ou tous, dont les sources ont changé depuis</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Panels</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Panels</source>
   <translation>Panneaux</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Put a flat panel in every face of the selected net</source>
   <translation>Mettre un panneau plan dans chaque face du réseau sélectionné</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Patches</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Developable patches</source>
   <translation>Surfaces développables</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Make the selected net of sheets that are cut flat and bent into place</source>
   <translation>Réaliser le réseau sélectionné en tôles découpées à plat puis cintrées en place</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Primitive</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>A net that is known exactly: sphere, catenoid, helicoid and others</source>
   <translation>Un réseau connu exactement : sphère, caténoïde, hélicoïde et autres</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Primitive</source>
   <translation>Primitive</translation>
  </message>
 </context>
 <context>
  <name>Ortho_QuadsFromMesh</name>
  <message>
   <location filename="../../../freecad_ortho/commands/remesh.py" />
   <source>Quads from triangles</source>
   <translation>Quads de triangles</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/remesh.py" />
   <source>Remesh the selected triangle mesh, or an STL, OBJ, PLY or GLB file, to a net of quads</source>
   <translation>Remailler le maillage de triangles sélectionné, ou un fichier STL, OBJ, PLY ou GLB, en un réseau de quadrilatères</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Refine</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>More or fewer parameter lines of the selected net, or rows cut off</source>
   <translation>Plus ou moins de lignes paramétriques du réseau sélectionné, ou des rangées coupées</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Subdivide, coarsen, trim</source>
   <translation>Subdiviser, grossir, rogner</translation>
  </message>
 </context>
 <context>
  <name>Ortho_SavePicture</name>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Save picture</source>
   <translation>Enregistrer l'image</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/display.py" />
   <source>Save what the 3D view shows, at any size</source>
   <translation>Enregistrer ce que montre la vue 3D, à toute taille</translation>
  </message>
 </context>
 <context>
  <name>Ortho_StructuralCheck</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Check the grid shell on the selected net as a frame under loads</source>
   <translation>Vérifier la résille du réseau choisi comme ossature sous charges</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structural_check.py" />
   <source>Structural check</source>
   <translation>Vérification statique</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Transform</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Move, turn, scale, mirror, turn over or bend the selected net (Moebius transformation)</source>
   <translation>Déplacer, tourner, mettre à l'échelle, refléter, retourner ou courber le réseau sélectionné (transformation de Möbius)</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Transform net</source>
   <translation>Transformer le réseau</translation>
  </message>
 </context>
 <context>
  <name>Ortho_UpdateStructures</name>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Build those structures and flat patterns anew that wait because they take long</source>
   <translation>Reconstruire les structures et développés en attente parce qu'ils sont longs à construire</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/structures.py" />
   <source>Update structures</source>
   <translation>Mettre à jour les structures</translation>
  </message>
 </context>
 <context>
  <name>Ortho_Weld</name>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Join nets, or one with itself, where borders meet</source>
   <translation>Réunir des réseaux, ou un réseau avec lui-même, là où les bords se touchent</translation>
  </message>
  <message>
   <location filename="../../../freecad_ortho/commands/sources.py" />
   <source>Weld nets</source>
   <translation>Souder des réseaux</translation>
  </message>
 </context>
 <context>
  <name>Workbench</name>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Analyse</source>
   <translation>&amp;Analyse</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Design</source>
   <translation>&amp;Conception</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Examples</source>
   <translation>&amp;Exemples</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Fabricate</source>
   <translation>&amp;Fabrication</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>&amp;Optimise</source>
   <translation>&amp;Optimisation</translation>
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
   <translation>Ortho Conception</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Ortho Fabricate</source>
   <translation>Ortho Fabrication</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Ortho Optimise</source>
   <translation>Ortho Optimisation</translation>
  </message>
  <message>
   <location filename="../../../InitGui.py" />
   <source>Turn freeform quad meshes into buildings of flat beams and panels</source>
   <translation>Faire de maillages libres de quadrilatères des bâtiments de poutres et panneaux plans</translation>
  </message>
 </context>
</TS>
