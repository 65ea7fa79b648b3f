// A plane mesh turned about the axis: hexahedra, and prisms at the axis. The files beside it were made by Gmsh 4.8.4:
// gmsh -3 -setnumber Mesh.SaveParametric 1 -format msh41 -o wedge_41.msh wedge.geo (and msh22).
Point(1)={0,0,0,0.5}; Point(2)={2,0,0,0.5}; Point(3)={2,0,1,0.5}; Point(4)={0,0,1,0.5};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1};
Curve Loop(1)={1,2,3,4}; Plane Surface(1)={1};
Transfinite Curve{1,3}=5; Transfinite Curve{2,4}=4; Transfinite Surface{1}; Recombine Surface{1};
out[]=Extrude{{0,0,1},{0,0,0},Pi/6}{Surface{1}; Layers{1}; Recombine;};
Physical Volume("wedge")={out[1]};
Physical Surface("side 1")={1};
