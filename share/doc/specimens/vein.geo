// A block of granite, 40 × 80 mm, with an inclined vein of quartz; in mm. With Gmsh:
//
//     gmsh vein.geo -2 -format msh41 -o vein.msh
h = 3.5;
Mesh.Algorithm = 5;  // Delaunay: the default, frontal, makes meshes that resemble lattices, and lattices steer cracks
Point(1) = {0, 0, 0, h};
Point(2) = {40, 0, 0, h};
Point(3) = {40, 52, 0, h};
Point(4) = {40, 60, 0, h};
Point(5) = {40, 80, 0, h};
Point(6) = {0, 80, 0, h};
Point(7) = {0, 28, 0, h};
Point(8) = {0, 20, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 1};
Line(9) = {8, 3};
Line(10) = {7, 4};
Curve Loop(1) = {1, 2, -9, 8};
Curve Loop(2) = {9, 3, -10, 7};
Curve Loop(3) = {10, 4, 5, 6};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Physical Surface("granite") = {1, 3};
Physical Surface("quartz") = {2};
Physical Curve("flaw-vein_wall") = {9, 10};
