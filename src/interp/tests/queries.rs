use super::{debug, error};

#[test]
fn objects_answer_while_the_scene_is_read() {
    let text = "#declare S=sphere{<1,2,3>,0.1 scale 3} #declare N=x; \
        #macro V(P) #debug concat(vstr(3,P,\",\",0,3),\" \") #end ";
    let cases = [
        ("V(min_extent(S)) V(max_extent(S))", "2.700,5.700,8.700 3.300,6.300,9.300 "),
        ("V(trace(S,<3,6,0>,z*5,N)) V(N)", "3.000,6.000,8.700 0.000,0.000,-1.000 "),
        ("V(trace(S,<3,6,9>,z,N)) V(N)", "3.000,6.000,9.300 0.000,0.000,1.000 "),
        ("V(trace(S,<30,6,9>,z,N)) V(N)", "0.000,0.000,0.000 0.000,0.000,0.000 "),
        (
            "#declare A=array[2]{x,y} V(trace(S,<3,6,0>,z,A[1])) V(A[1])",
            "3.000,6.000,8.700 0.000,0.000,-1.000 ",
        ),
        ("#debug concat(str(inside(S,<3,6,9>),0,0),str(inside(S,0),0,0))", "10"),
        (
            "#declare P=plane{y,0} V(min_extent(P)) V(max_extent(P))",
            "-10000000000.000,-10000000000.000,-10000000000.000 10000000000.000,10000000000.000,10000000000.000 ",
        ),
    ];
    for (question, answer) in cases {
        assert_eq!(debug(&format!("{text}{question}")), answer, "{question}");
    }
    assert!(
        error(&format!("{text} #declare F=5; #declare P=trace(S,0,z,F);"))
            .contains("expected a vector variable")
    );
    assert!(error("#declare T=triangle{x,y,z} #declare I=inside(T,0);").contains("no inside"));
}
