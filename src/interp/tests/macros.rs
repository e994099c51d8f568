use super::{debug, error, shown};

#[test]
fn a_macro_may_be_an_expression_and_its_text_is_what_counts() {
    let text = "#macro M() #local T=7; T*2 #end #declare R=M(); #declare S=2+M(); #macro P() 1+2 #end #declare Q=2*P();";
    assert_eq!(debug(&format!("{text}{}", shown(&["R", "S", "Q"]))), "14.000000 16.000000 4.000000 ");
}

#[test]
fn a_local_returned_bare_is_read_in_time() {
    let text = "#macro M() #local P=<1,2,3>; P #end #declare V=M();";
    assert_eq!(debug(&format!("{text}{}", shown(&["V.z"]))), "3.000000 ");
    let text = "#macro M() #local P=array[2]{4,5}; P[1] #end #declare V=M();";
    assert_eq!(debug(&format!("{text}{}", shown(&["V"]))), "5.000000 ");
}

#[test]
fn a_lone_identifier_is_passed_by_reference() {
    let text = "#macro Inc(P) #declare P=P+1; #end #macro IncL(P) #local P=P+1; #end #declare A=1; #declare B=array[2]{5,6};";
    let calls = "Inc(A) IncL(A) Inc(B[1]) Inc((A)) Inc(+A) Inc(A*1)";
    assert_eq!(
        debug(&format!("{text}{calls}{}", shown(&["A", "B[0]", "B[1]"]))),
        "3.000000 5.000000 7.000000 "
    );
    // Through two calls.
    let text =
        format!("{text} #macro Twice(Q) Inc(Q) Inc(Q) #end Twice(A) Twice(B[0]){}", shown(&["A", "B[0]"]));
    assert_eq!(debug(&text), "3.000000 7.000000 ");
}

#[test]
fn arguments_may_be_whole_arrays_and_their_elements_in_expressions() {
    let text = "#macro Set(A,I,V) #declare A[I]=V; #end #declare B=array[3]{1,2,3}; Set(B,1,B[2]*10+B[0])";
    assert_eq!(debug(&format!("{text}{}", shown(&["B[1]"]))), "31.000000 ");
}

#[test]
fn scope_is_dynamic() {
    let text = "#declare G=1; #macro Inner() #declare G=G+10; #debug str(L,0,0) #end \
                #macro Outer() #local L=5; #local G=100; Inner() #debug str(G,0,0) #end Outer() #debug str(G,0,0)";
    assert_eq!(debug(text), "51101");
    // A new name declared in a macro is global; a local one is gone.
    let text = "#macro M() #declare N=7; #local K=8; #end M() #debug str(N,0,0) #ifdef(K) #debug \"K\" #end";
    assert_eq!(debug(text), "7");
}

#[test]
fn recursion_works_to_the_limit() {
    let text = |n: u32| format!("#macro F(N) #if (N>1) F(N-1) #else #debug \"deep\" #end #end F({n})");
    assert_eq!(debug(&text(98)), "deep");
    assert!(error(&text(99)).contains("98 macro calls"));
    let text = "#macro Fac(N) #if (N<2) 1 #else N*Fac(N-1) #end #end #debug str(Fac(10),0,0)";
    assert_eq!(debug(text), "3628800");
}

#[test]
fn loops_in_macros_are_replayed() {
    let text = "#macro Sum(N) #local S=0; #local I=0; #while (I<N) #local I=I+1; #for (J,1,I) #local S=S+J; #end #end S #end";
    assert_eq!(debug(&format!("{text} #debug str(Sum(10),0,0) #debug str(Sum(3),0,0)")), "22010");
}

#[test]
fn a_macro_may_be_replaced_and_defined_in_a_loop() {
    let text = "#for (I,1,2) #macro M() #debug str(I,0,0) #end M() #end #macro M() #debug \"x\" #end M()";
    assert_eq!(debug(text), "12x");
}

#[test]
fn argument_counts_are_checked() {
    let text = "#macro M(A,B) #end ";
    assert!(error(&format!("{text} M(1)")).contains("has 2 parameters, but 1 came"));
    assert!(error(&format!("{text} M(1,2,3)")).contains("expected `)`"));
    assert!(error(&format!("{text} M")).contains("expected `(`"));
    assert_eq!(debug(&format!("{text} M(1,2,) M(1 2) #debug \"ok\"")), "ok");
}

#[test]
fn an_unset_argument_is_an_error() {
    assert!(error("#macro M(A) #end M(Nothing)").contains("Nothing"));
}

#[test]
fn macros_yield_parts_of_vectors_and_directives() {
    let text = "#macro C() 1, 2, 3 #end #declare V=<C()>; #macro D(S) #debug S #end D(\"hi\")";
    assert_eq!(debug(&format!("{text}{}", shown(&["V.z"]))), "hi3.000000 ");
}

#[test]
fn a_macro_may_define_another() {
    assert_eq!(debug("#macro O() #macro I() #debug \"i\" #end I() #end O() O() I()"), "iii");
}

#[test]
fn a_local_stays_in_its_table_whatever_the_right_side_calls() {
    let text = "#macro Inner() #local Q=7; #if (1) Q; #else 0; #end #end \
                #macro Outer() #local R=Inner() #debug str(R,0,0) #end Outer() #ifdef(R) #debug \"R\" #end";
    assert_eq!(debug(text), "7");
}

#[test]
fn an_element_looked_up_disturbs_no_variable() {
    let text = "#declare S=array[2]{\"a\",\"b\"}; #declare O=array[1]{sphere{0,1}}; #debug S[1] object{O[0]}";
    assert_eq!(debug(&format!("{text}{}", shown(&["image_width"]))), "b160.000000 ");
}

#[test]
fn undef_of_a_parameter_leaves_the_variable() {
    let text = "#macro M(A) #undef A #ifdef(A) #debug \"A\" #end #end #declare X=1; M(X) #ifdef(X) #debug \"X\" #end";
    assert_eq!(debug(text), "X");
    let text = "#macro M(A) #undef A[0] #end #declare X=array[1]{1}; M(X) #ifdef(X[0]) #debug \"X\" #end";
    assert_eq!(debug(text), "");
}

#[test]
fn a_local_that_a_macro_yields_can_be_an_argument() {
    let text = "#macro Sum(A,B) #local S=A+B; S #end #macro Show(V) #debug str(V,0,0) #end Show(Sum(1,2)) Show(Sum(Sum(1,2),4))";
    assert_eq!(debug(text), "37");
    let text = "#macro Made() #local L=array[2]{5,6} L #end #macro Second(L) #debug str(L[1],0,0) #end Second(Made())";
    assert_eq!(debug(text), "6");
}
