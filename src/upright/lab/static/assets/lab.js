const bg="uplot",yg="u-hz",xg="u-vt",Mg="u-title",Sg="u-wrap",wg="u-under",Eg="u-over",Tg="u-axis",Is="u-off",Ag="u-select",Rg="u-cursor-x",Cg="u-cursor-y",Pg="u-cursor-pt",Lg="u-legend",Ng="u-live",Dg="u-inline",Ig="u-series",kg="u-marker",wu="u-label",Ug="u-value",pr="width",mr="height";const Eu="bottom",co="left",gl="right",gh="#000",Tu=gh+"0",_l="mousemove",Au="mousedown",vl="mouseup",Ru="mouseenter",Cu="mouseleave",Pu="dblclick",Fg="resize",Og="scroll",Lu="change",Ca="dppxchange",_h="--",qo=typeof window<"u",cc=qo?document:null,Po=qo?window:null,zg=qo?navigator:null;let St,Vr;function hc(){let i=devicePixelRatio;St!=i&&(St=i,Vr&&dc(Lu,Vr,hc),Vr=matchMedia(`(min-resolution: ${St-.001}dppx) and (max-resolution: ${St+.001}dppx)`),Bs(Lu,Vr,hc),Po.dispatchEvent(new CustomEvent(Ca)))}function On(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function uc(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Ut(i,e,t){i.style[e]=t+"px"}function si(i,e,t,n){let s=cc.createElement(i);return e!=null&&On(s,e),t?.insertBefore(s,n),s}function Xn(i,e){return si("div",i,e)}const Nu=new WeakMap;function vi(i,e,t,n,s){let o="translate("+e+"px,"+t+"px)",r=Nu.get(i);o!=r&&(i.style.transform=o,Nu.set(i,o),e<0||t<0||e>n||t>s?On(i,Is):uc(i,Is))}const Du=new WeakMap;function Iu(i,e,t){let n=e+t,s=Du.get(i);n!=s&&(Du.set(i,n),i.style.background=e,i.style.borderColor=t)}const ku=new WeakMap;function Uu(i,e,t,n){let s=e+""+t,o=ku.get(i);s!=o&&(ku.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}const vh={passive:!0},Bg={...vh,capture:!0};function Bs(i,e,t,n){e.addEventListener(i,t,n?Bg:vh)}function dc(i,e,t,n){e.removeEventListener(i,t,vh)}qo&&hc();function ri(i,e,t,n){let s;t=t||0,n=n||e.length-1;let o=n<=2147483647;for(;n-t>1;)s=o?t+n>>1:Bn((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function tp(i){return(t,n,s)=>{let o=-1,r=-1;for(let a=n;a<=s;a++)if(i(t[a])){o=a;break}for(let a=s;a>=n;a--)if(i(t[a])){r=a;break}return[o,r]}}const np=i=>i!=null,ip=i=>i!=null&&i>0,qa=tp(np),Hg=tp(ip);function Vg(i,e,t,n=0,s=!1){let o=s?Hg:qa,r=s?ip:np;[e,t]=o(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];r(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Pt,l??-Pt]}function Xa(i,e,t,n){let s=zu(i),o=zu(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let r=t==10?Hi:sp,a=s==1?Bn:Yn,l=o==1?Yn:Bn,c=a(r(Qt(i))),h=l(r(Qt(e))),u=Io(t,c),d=Io(t,h);return t==10&&(c<0&&(u=Lt(u,-c)),h<0&&(d=Lt(d,-h))),n||t==2?(i=u*s,e=d*o):(i=lp(i,u),e=ja(e,d)),[i,e]}function bh(i,e,t,n){let s=Xa(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}const yh=.1,Fu={mode:3,pad:yh},yr={pad:0,soft:null,mode:0},Gg={min:yr,max:yr};function Pa(i,e,t,n){return Ya(t)?Ou(i,e,t):(yr.pad=t,yr.soft=n?0:null,yr.mode=n?3:0,Ou(i,e,Gg))}function yt(i,e){return i??e}function Wg(i,e,t){for(e=yt(e,0),t=yt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Ou(i,e,t){let n=t.min,s=t.max,o=yt(n.pad,0),r=yt(s.pad,0),a=yt(n.hard,-Pt),l=yt(s.hard,Pt),c=yt(n.soft,Pt),h=yt(s.soft,-Pt),u=yt(n.mode,0),d=yt(s.mode,0),p=e-i,g=Hi(p),_=En(Qt(i),Qt(e)),m=Hi(_),f=Qt(m-g);(p<1e-24||f>10)&&(p=0,(i==0||e==0)&&(p=1e-24,u==2&&c!=Pt&&(o=0),d==2&&h!=-Pt&&(r=0)));let M=p||_||1e3,S=Hi(M),b=Io(10,Bn(S)),F=M*(p==0?i==0?.1:1:o),L=Lt(lp(i-F,b/10),24),A=i>=c&&(u==1||u==3&&L<=c||u==2&&L>=c)?c:Pt,U=En(a,L<A&&i>=A?A:ai(A,L)),E=M*(p==0?e==0?.1:1:r),x=Lt(ja(e+E,b/10),24),C=e<=h&&(d==1||d==3&&x>=h||d==2&&x<=h)?h:-Pt,V=ai(l,x>C&&e<=C?C:En(C,x));return U==V&&U==0&&(V=100),[U,V]}const $g=new Intl.NumberFormat(qo?zg.language:"en-US"),xh=i=>$g.format(i),Hn=Math,ba=Hn.PI,Qt=Hn.abs,Bn=Hn.floor,Jt=Hn.round,Yn=Hn.ceil,ai=Hn.min,En=Hn.max,Io=Hn.pow,zu=Hn.sign,Hi=Hn.log10,sp=Hn.log2,qg=(i,e=1)=>Hn.sinh(i)*e,bl=(i,e=1)=>Hn.asinh(i/e),Pt=1/0;function Bu(i){return(Hi((i^i>>31)-(i>>31))|0)+1}function fc(i,e,t){return ai(En(i,e),t)}function op(i){return typeof i=="function"}function ct(i){return op(i)?i:()=>i}const Xg=()=>{},rp=i=>i,ap=(i,e)=>e,jg=i=>null,Hu=i=>!0,Vu=(i,e)=>i==e,Yg=/\.\d*?(?=9{6,}|0{6,})/gm,Ws=i=>{if(hp(i)||ds.has(i))return i;const e=`${i}`,t=e.match(Yg);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,o]=e.split("e");return+`${Ws(s)}e${o}`}return Lt(i,n)};function Ls(i,e){return Ws(Lt(Ws(i/e))*e)}function ja(i,e){return Ws(Yn(Ws(i/e))*e)}function lp(i,e){return Ws(Bn(Ws(i/e))*e)}function Lt(i,e=0){if(hp(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return Jt(n)/t}const ds=new Map;function cp(i){return((""+i).split(".")[1]||"").length}function Sr(i,e,t,n){let s=[],o=n.map(cp);for(let r=e;r<t;r++){let a=Qt(r),l=Lt(Io(i,r),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${r}`:n[c]*l,u=(r>=0?0:a)+(r>=o[c]?0:o[c]),d=i==10?h:Lt(h,u);s.push(d),ds.set(d,u)}}return s}const xr={},Mh=[],ko=[null,null],ss=Array.isArray,hp=Number.isInteger,Kg=i=>i===void 0;function Gu(i){return typeof i=="string"}function Ya(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function Zg(i){return i!=null&&typeof i=="object"}const Jg=Object.getPrototypeOf(Uint8Array),up="__proto__";function Uo(i,e=Ya){let t;if(ss(i)){let n=i.find(s=>s!=null);if(ss(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Uo(i[s],e)}else t=i.slice()}else if(i instanceof Jg)t=i.slice();else if(e(i)){t={};for(let n in i)n!=up&&(t[n]=Uo(i[n],e))}else t=i;return t}function jt(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=up&&(Ya(i[s])?jt(i[s],Uo(n[s])):i[s]=Uo(n[s]))}return i}const Qg=0,e0=1,t0=2;function n0(i,e,t){for(let n=0,s,o=-1;n<e.length;n++){let r=e[n];if(r>o){for(s=r-1;s>=0&&i[s]==null;)i[s--]=null;for(s=r+1;s<t&&i[s]==null;)i[o=s++]=null}}}function i0(i,e){if(r0(i)){let r=i[0].slice();for(let a=1;a<i.length;a++)r.push(...i[a].slice(1));return a0(r[0])||(r=o0(r)),r}let t=new Set;for(let r=0;r<i.length;r++){let l=i[r][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((r,a)=>r-a)],s=n[0].length,o=new Map;for(let r=0;r<s;r++)o.set(n[0][r],r);for(let r=0;r<i.length;r++){let a=i[r],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[r][c]:e0,p=[];for(let g=0;g<h.length;g++){let _=h[g],m=o.get(l[g]);_===null?d!=Qg&&(u[m]=_,d==t0&&p.push(m)):u[m]=_}n0(u,p,s),n.push(u)}}return n}const s0=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function o0(i){let e=i[0],t=e.length,n=Array(t);for(let o=0;o<n.length;o++)n[o]=o;n.sort((o,r)=>e[o]-e[r]);let s=[];for(let o=0;o<i.length;o++){let r=i[o],a=Array(t);for(let l=0;l<t;l++)a[l]=r[n[l]];s.push(a)}return s}function r0(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let o=0;o<t;o++)if(s[o]!=e[o])return!1}}return!0}function a0(i,e=100){const t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const o=En(1,Bn((s-n+1)/e));for(let r=i[n],a=n+o;a<=s;a+=o){const l=i[a];if(l!=null){if(l<=r)return!1;r=l}}return!0}const dp=["January","February","March","April","May","June","July","August","September","October","November","December"],fp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function pp(i){return i.slice(0,3)}const l0=fp.map(pp),c0=dp.map(pp),h0={MMMM:dp,MMM:c0,WWWW:fp,WWW:l0};function or(i){return(i<10?"0":"")+i}function u0(i){return(i<10?"00":i<100?"0":"")+i}const d0={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>or(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>or(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>or(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>or(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>or(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>u0(i.getMilliseconds())};function Sh(i,e){e=e||h0;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?d0[s[1]]:s[0]);return o=>{let r="";for(let a=0;a<t.length;a++)r+=typeof t[a]=="string"?t[a]:t[a](o,e);return r}}const f0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function p0(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==f0?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}const mp=i=>i%1==0,La=[1,2,2.5,5],m0=Sr(10,-32,0,La),gp=Sr(10,0,32,La),g0=gp.filter(mp),Ns=m0.concat(gp),wh=`
`,_p="{YYYY}",Wu=wh+_p,vp="{M}/{D}",gr=wh+vp,Gr=gr+"/{YY}",bp="{aa}",_0="{h}:{mm}",Ao=_0+bp,$u=wh+Ao,qu=":{ss}",Et=null;function yp(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,o=s*30,r=s*365,l=(i==1?Sr(10,0,3,La).filter(mp):Sr(10,-3,0,La)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,o,o*2,o*3,o*4,o*6,r,r*2,r*5,r*10,r*25,r*50,r*100]);const c=[[r,_p,Et,Et,Et,Et,Et,Et,1],[s*28,"{MMM}",Wu,Et,Et,Et,Et,Et,1],[s,vp,Wu,Et,Et,Et,Et,Et,1],[n,"{h}"+bp,Gr,Et,gr,Et,Et,Et,1],[t,Ao,Gr,Et,gr,Et,Et,Et,1],[e,qu,Gr+" "+Ao,Et,gr+" "+Ao,Et,$u,Et,1],[i,qu+".{fff}",Gr+" "+Ao,Et,gr+" "+Ao,Et,$u,Et,1]];function h(u){return(d,p,g,_,m,f)=>{let M=[],S=m>=r,b=m>=o&&m<r,F=u(g),L=Lt(F*i,3),A=yl(F.getFullYear(),S?0:F.getMonth(),b||S?1:F.getDate()),U=Lt(A*i,3);if(b||S){let E=b?m/o:0,x=S?m/r:0,C=L==U?L:Lt(yl(A.getFullYear()+x,A.getMonth()+E,1)*i,3),V=new Date(Jt(C/i)),O=V.getFullYear(),q=V.getMonth();for(let $=0;C<=_;$++){let X=yl(O+x*$,q+E*$,1),Y=X-u(Lt(X*i,3));C=Lt((+X+Y)*i,3),C<=_&&M.push(C)}}else{let E=m>=s?s:m,x=Bn(g)-Bn(L),C=U+x+ja(L-U,E);M.push(C);let V=u(C),O=V.getHours()+V.getMinutes()/t+V.getSeconds()/n,q=m/n,$=d.axes[p]._space,X=f/$;for(;C=Lt(C+m,i==1?0:3),!(C>_);)if(q>1){let Y=Bn(Lt(O+q,6))%24,ce=u(C).getHours()-Y;ce>1&&(ce=-1),C-=ce*n,O=(O+q)%24;let _e=M[M.length-1];Lt((C-_e)/m,3)*X>=.7&&M.push(C)}else M.push(C)}return M}}return[l,c,h]}const[v0,b0,y0]=yp(1),[x0,M0,S0]=yp(.001);Sr(2,-53,53,[1]);function Xu(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function ju(i,e){return(t,n,s,o,r)=>{let a=e.find(g=>r>=g[0])||e[e.length-1],l,c,h,u,d,p;return n.map(g=>{let _=i(g),m=_.getFullYear(),f=_.getMonth(),M=_.getDate(),S=_.getHours(),b=_.getMinutes(),F=_.getSeconds(),L=m!=l&&a[2]||f!=c&&a[3]||M!=h&&a[4]||S!=u&&a[5]||b!=d&&a[6]||F!=p&&a[7]||a[1];return l=m,c=f,h=M,u=S,d=b,p=F,L(_)})}}function w0(i,e){let t=Sh(e);return(n,s,o,r,a)=>s.map(l=>t(i(l)))}function yl(i,e,t){return new Date(i,e,t)}function Yu(i,e){return e(i)}const E0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Ku(i,e){return(t,n,s,o)=>o==null?_h:e(i(n))}function T0(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function A0(i,e){return i.series[e].fill(i,e)}const R0={show:!0,live:!0,isolate:!1,mount:Xg,markers:{show:!0,width:2,stroke:T0,fill:A0,dash:"solid"},idx:null,idxs:null,values:[]};function C0(i,e){let t=i.cursor.points,n=Xn(),s=t.size(i,e);Ut(n,pr,s),Ut(n,mr,s);let o=s/-2;Ut(n,"marginLeft",o),Ut(n,"marginTop",o);let r=t.width(i,e,s);return r&&Ut(n,"borderWidth",r),n}function P0(i,e){let t=i.series[e].points;return t._fill||t._stroke}function L0(i,e){let t=i.series[e].points;return t._stroke||t._fill}function N0(i,e){return i.series[e].points.size}const xl=[0,0];function D0(i,e,t){return xl[0]=e,xl[1]=t,xl}function Wr(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Ml(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}const I0={show:!0,x:!0,y:!0,lock:!1,move:D0,points:{one:!1,show:C0,size:N0,width:0,stroke:L0,fill:P0},bind:{mousedown:Wr,mouseup:Wr,click:Wr,dblclick:Wr,mousemove:Ml,mouseleave:Ml,mouseenter:Ml},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},xp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Eh=jt({},xp,{filter:ap}),Mp=jt({},Eh,{size:10}),Sp=jt({},xp,{show:!1}),Th='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',wp="bold "+Th,Ep=1.5,Zu={show:!0,scale:"x",stroke:gh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wp,side:2,grid:Eh,ticks:Mp,border:Sp,font:Th,lineGap:Ep,rotate:0},k0="Value",U0="Time",Ju={show:!0,scale:"x",auto:!1,sorted:1,min:Pt,max:-Pt,idxs:[]};function F0(i,e,t,n,s){return e.map(o=>o==null?"":xh(o))}function O0(i,e,t,n,s,o,r){let a=[],l=ds.get(s)||0;t=r?t:Lt(ja(t,s),l);for(let c=t;c<=n;c=Lt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function pc(i,e,t,n,s,o,r){const a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Hi:sp,h=Bn(c(t));s=Io(l,h),l==10&&(s=Ns[ri(s,Ns)]);let u=t,d=s*l;l==10&&(d=Ns[ri(d,Ns)]);do a.push(u),u=u+s,l==10&&!ds.has(u)&&(u=Lt(u,ds.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Ns[ri(d,Ns)]));while(u<=n);return a}function z0(i,e,t,n,s,o,r){let l=i.scales[i.axes[e].scale].asinh,c=n>l?pc(i,e,En(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?pc(i,e,En(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}const Tp=/./,B0=/[12357]/,H0=/[125]/,Qu=/1/,mc=(i,e,t,n)=>i.map((s,o)=>e==4&&s==0||o%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function V0(i,e,t,n,s){let o=i.axes[t],r=o.scale,a=i.scales[r],l=i.valToPos,c=o._space,h=l(10,r),u=l(9,r)-h>=c?Tp:l(7,r)-h>=c?B0:l(5,r)-h>=c?H0:Qu;if(u==Qu){let d=Qt(l(1,r)-h);if(d<c)return mc(e.slice().reverse(),a.distr,u,Yn(c/d)).reverse()}return mc(e,a.distr,u,1)}function G0(i,e,t,n,s){let o=i.axes[t],r=o.scale,a=o._space,l=i.valToPos,c=Qt(l(1,r)-l(2,r));return c<a?mc(e.slice().reverse(),3,Tp,Yn(a/c)).reverse():e}function W0(i,e,t,n){return n==null?_h:e==null?"":xh(e)}const ed={show:!0,scale:"y",stroke:gh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wp,side:3,grid:Eh,ticks:Mp,border:Sp,font:Th,lineGap:Ep,rotate:0};function $0(i,e){let t=3+(i||1)*2;return Lt(t*e,3)}function q0(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],o=i.valToPos(s[n[0]],t,!0),r=i.valToPos(s[n[1]],t,!0),a=Qt(r-o),l=i.series[e],c=a/(l.points.space*St);return n[1]-n[0]<=c}const td={scale:null,auto:!0,sorted:0,min:Pt,max:-Pt},Ap=(i,e,t,n,s)=>s,nd={show:!0,auto:!0,sorted:0,gaps:Ap,alpha:1,facets:[jt({},td,{scale:"x"}),jt({},td,{scale:"y"})]},id={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ap,alpha:1,points:{show:q0,filter:null},values:null,min:Pt,max:-Pt,idxs:[],path:null,clip:null};function X0(i,e,t,n,s){return t/10}const Rp={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},j0=jt({},Rp,{time:!1,ori:1}),sd={};function Cp(i,e){let t=sd[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,o,r,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,o,r,a,l,c)}},i!=null&&(sd[i]=t)),t}const Fo=1,gc=2;function Ks(i,e,t){const n=i.mode,s=i.series[e],o=n==2?i._data[e]:i._data,r=i.scales,a=i.bbox;let l=o[0],c=n==2?o[1]:o[e],h=n==2?r[s.facets[0].scale]:r[i.series[0].scale],u=n==2?r[s.facets[1].scale]:r[s.scale],d=a.left,p=a.top,g=a.width,_=a.height,m=i.valToPosH,f=i.valToPosV;return h.ori==0?t(s,l,c,h,u,m,f,d,p,g,_,Za,Xo,Qa,Lp,Dp):t(s,l,c,h,u,f,m,p,d,_,g,Ja,jo,Ch,Np,Ip)}function Ah(i,e){let t=0,n=0,s=yt(i.bands,Mh);for(let o=0;o<s.length;o++){let r=s[o];r.series[0]==e?t=r.dir:r.series[1]==e&&(r.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Y0(i,e,t,n,s){let o=i.mode,r=i.series[e],a=o==2?r.facets[1].scale:r.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Vi(i,e,t,n,s,o){return Ks(i,e,(r,a,l,c,h,u,d,p,g,_,m)=>{let f=r.pxRound;const M=c.dir*(c.ori==0?1:-1),S=c.ori==0?Xo:jo;let b,F;M==1?(b=t,F=n):(b=n,F=t);let L=f(u(a[b],c,_,p)),A=f(d(l[b],h,m,g)),U=f(u(a[F],c,_,p)),E=f(d(o==1?h.max:h.min,h,m,g)),x=new Path2D(s);return S(x,U,E),S(x,L,E),S(x,L,A),x})}function Ka(i,e,t,n,s,o){let r=null;if(i.length>0){r=new Path2D;const a=e==0?Qa:Ch;let l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let p=d[0]-l;p>0&&a(r,l,n,p,n+o),l=d[1]}}let c=t+s-l,h=10;c>0&&a(r,l,n-h/2,c,n+o+h)}return r}function K0(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Rh(i,e,t,n,s,o,r){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let p=o(i[u]),g=d==u?p:o(i[d]),_=u-s;p=r<=0&&_>=0&&_<l?o(i[_]):p;let f=d+s;g=r>=0&&f>=0&&f<l?o(i[f]):g,g>=p&&a.push([p,g])}return a}function od(i){return i==0?rp:i==1?Jt:e=>Ls(e,i)}function Pp(i){let e=i==0?Za:Ja,t=i==0?(s,o,r,a,l,c)=>{s.arcTo(o,r,a,l,c)}:(s,o,r,a,l,c)=>{s.arcTo(r,o,l,a,c)},n=i==0?(s,o,r,a,l)=>{s.rect(o,r,a,l)}:(s,o,r,a,l)=>{s.rect(r,o,l,a)};return(s,o,r,a,l,c=0,h=0)=>{c==0&&h==0?n(s,o,r,a,l):(c=ai(c,a/2,l/2),h=ai(h,a/2,l/2),e(s,o+c,r),t(s,o+a,r,o+a,r+l,c),t(s,o+a,r+l,o,r+l,h),t(s,o,r+l,o,r,h),t(s,o,r,o+a,r,c),s.closePath())}}const Za=(i,e,t)=>{i.moveTo(e,t)},Ja=(i,e,t)=>{i.moveTo(t,e)},Xo=(i,e,t)=>{i.lineTo(e,t)},jo=(i,e,t)=>{i.lineTo(t,e)},Qa=Pp(0),Ch=Pp(1),Lp=(i,e,t,n,s,o)=>{i.arc(e,t,n,s,o)},Np=(i,e,t,n,s,o)=>{i.arc(t,e,n,s,o)},Dp=(i,e,t,n,s,o,r)=>{i.bezierCurveTo(e,t,n,s,o,r)},Ip=(i,e,t,n,s,o,r)=>{i.bezierCurveTo(t,e,s,n,r,o)};function kp(i){return(e,t,n,s,o)=>Ks(e,t,(r,a,l,c,h,u,d,p,g,_,m)=>{let{pxRound:f,points:M}=r,S,b;c.ori==0?(S=Za,b=Lp):(S=Ja,b=Np);const F=Lt(M.width*St,3);let L=(M.size-M.width)/2*St,A=Lt(L*2,3),U=new Path2D,E=new Path2D,{left:x,top:C,width:V,height:O}=e.bbox;Qa(E,x-A,C-A,V+A*2,O+A*2);const q=$=>{if(l[$]!=null){let X=f(u(a[$],c,_,p)),Y=f(d(l[$],h,m,g));S(U,X+L,Y),b(U,X,Y,L,0,ba*2)}};if(o)o.forEach(q);else for(let $=n;$<=s;$++)q($);return{stroke:F>0?U:null,fill:U,clip:E,flags:Fo|gc}})}function Up(i){return(e,t,n,s,o,r)=>{n!=s&&(o!=n&&r!=n&&i(e,t,n),o!=s&&r!=s&&i(e,t,s),i(e,t,r))}}const Z0=Up(Xo),J0=Up(jo);function Fp(i){const e=yt(i?.alignGaps,0);return(t,n,s,o)=>Ks(t,n,(r,a,l,c,h,u,d,p,g,_,m)=>{[s,o]=qa(l,s,o);let f=r.pxRound,M=O=>f(u(O,c,_,p)),S=O=>f(d(O,h,m,g)),b,F;c.ori==0?(b=Xo,F=Z0):(b=jo,F=J0);const L=c.dir*(c.ori==0?1:-1),A={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},U=A.stroke;let E=!1;if(o-s>=_*4){let O=me=>t.posToVal(me,c.key,!0),q=null,$=null,X,Y,ee,ae=M(a[L==1?s:o]),ce=M(a[s]),_e=M(a[o]),be=O(L==1?ce+1:_e-1);for(let me=L==1?s:o;me>=s&&me<=o;me+=L){let oe=a[me],ve=(L==1?oe<be:oe>be)?ae:M(oe),he=l[me];ve==ae?he!=null?(Y=he,q==null?(b(U,ve,S(Y)),X=q=$=Y):Y<q?q=Y:Y>$&&($=Y)):he===null&&(E=!0):(q!=null&&F(U,ae,S(q),S($),S(X),S(Y)),he!=null?(Y=he,b(U,ve,S(Y)),q=$=X=Y):(q=$=null,he===null&&(E=!0)),ae=ve,be=O(ae+L))}q!=null&&q!=$&&ee!=ae&&F(U,ae,S(q),S($),S(X),S(Y))}else for(let O=L==1?s:o;O>=s&&O<=o;O+=L){let q=l[O];q===null?E=!0:q!=null&&b(U,M(a[O]),S(q))}let[C,V]=Ah(t,n);if(r.fill!=null||C!=0){let O=A.fill=new Path2D(U),q=r.fillTo(t,n,r.min,r.max,C),$=S(q),X=M(a[s]),Y=M(a[o]);L==-1&&([Y,X]=[X,Y]),b(O,Y,$),b(O,X,$)}if(!r.spanGaps){let O=[];E&&O.push(...Rh(a,l,s,o,L,M,e)),A.gaps=O=r.gaps(t,n,s,o,O),A.clip=Ka(O,c.ori,p,g,_,m)}return V!=0&&(A.band=V==2?[Vi(t,n,s,o,U,-1),Vi(t,n,s,o,U,1)]:Vi(t,n,s,o,U,V)),A})}function Q0(i){const e=yt(i.align,1),t=yt(i.ascDesc,!1),n=yt(i.alignGaps,0),s=yt(i.extend,!1);return(o,r,a,l)=>Ks(o,r,(c,h,u,d,p,g,_,m,f,M,S)=>{[a,l]=qa(u,a,l);let b=c.pxRound,{left:F,width:L}=o.bbox,A=ce=>b(g(ce,d,M,m)),U=ce=>b(_(ce,p,S,f)),E=d.ori==0?Xo:jo;const x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},C=x.stroke,V=d.dir*(d.ori==0?1:-1);let O=U(u[V==1?a:l]),q=A(h[V==1?a:l]),$=q,X=q;s&&e==-1&&(X=F,E(C,X,O)),E(C,q,O);for(let ce=V==1?a:l;ce>=a&&ce<=l;ce+=V){let _e=u[ce];if(_e==null)continue;let be=A(h[ce]),me=U(_e);e==1?E(C,be,O):E(C,$,me),E(C,be,me),O=me,$=be}let Y=$;s&&e==1&&(Y=F+L,E(C,Y,O));let[ee,ae]=Ah(o,r);if(c.fill!=null||ee!=0){let ce=x.fill=new Path2D(C),_e=c.fillTo(o,r,c.min,c.max,ee),be=U(_e);E(ce,Y,be),E(ce,X,be)}if(!c.spanGaps){let ce=[];ce.push(...Rh(h,u,a,l,V,A,n));let _e=c.width*St/2,be=t||e==1?_e:-_e,me=t||e==-1?-_e:_e;ce.forEach(oe=>{oe[0]+=be,oe[1]+=me}),x.gaps=ce=c.gaps(o,r,a,l,ce),x.clip=Ka(ce,d.ori,m,f,M,S)}return ae!=0&&(x.band=ae==2?[Vi(o,r,a,l,C,-1),Vi(o,r,a,l,C,1)]:Vi(o,r,a,l,C,ae)),x})}function rd(i,e,t,n,s,o,r=Pt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=Qt(i[l]-i[a]);h<c&&(c=h,r=Qt(t(i[l],n,s,o)-t(i[a],n,s,o)))}a=l}}return r}function e_(i){i=i||xr;const e=yt(i.size,[.6,Pt,1]),t=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const o=ct(s),r=1-e[0],a=yt(e[1],Pt),l=yt(e[2],1),c=yt(i.disp,xr),h=yt(i.each,p=>{}),{fill:u,stroke:d}=c;return(p,g,_,m)=>Ks(p,g,(f,M,S,b,F,L,A,U,E,x,C)=>{let V=f.pxRound,O=t,q=n*St,$=a*St,X=l*St,Y,ee;b.ori==0?[Y,ee]=o(p,g):[ee,Y]=o(p,g);const ae=b.dir*(b.ori==0?1:-1);let ce=b.ori==0?Qa:Ch,_e=b.ori==0?h:(j,ie,Se,ye,Ae,Ze,pe)=>{h(j,ie,Se,Ae,ye,pe,Ze)},be=yt(p.bands,Mh).find(j=>j.series[0]==g),me=be!=null?be.dir:0,oe=f.fillTo(p,g,f.min,f.max,me),ue=V(A(oe,F,C,E)),ve,he,Ie,Be=x,ke=V(f.width*St),ht=!1,Je=null,ut=null,G=null,Kt=null;u!=null&&(ke==0||d!=null)&&(ht=!0,Je=u.values(p,g,_,m),ut=new Map,new Set(Je).forEach(j=>{j!=null&&ut.set(j,new Path2D)}),ke>0&&(G=d.values(p,g,_,m),Kt=new Map,new Set(G).forEach(j=>{j!=null&&Kt.set(j,new Path2D)})));let{x0:et,size:nt}=c;if(et!=null&&nt!=null){O=1,M=et.values(p,g,_,m),et.unit==2&&(M=M.map(Se=>p.posToVal(U+Se*x,b.key,!0)));let j=nt.values(p,g,_,m);nt.unit==2?he=j[0]*x:he=L(j[0],b,x,U)-L(0,b,x,U),Be=rd(M,S,L,b,x,U,Be),Ie=Be-he+q}else Be=rd(M,S,L,b,x,U,Be),Ie=Be*r+q,he=Be-Ie;Ie<1&&(Ie=0),ke>=he/2&&(ke=0),Ie<5&&(V=rp);let We=Ie>0,pt=Be-Ie-(We?ke:0);he=V(fc(pt,X,$)),ve=(O==0?he/2:O==ae?0:he)-O*ae*((O==0?q/2:0)+(We?ke/2:0));const Ne={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},I=ht?null:new Path2D;let w=null;if(be!=null)w=p.data[be.series[1]];else{let{y0:j,y1:ie}=c;j!=null&&ie!=null&&(S=ie.values(p,g,_,m),w=j.values(p,g,_,m))}let Q=Y*he,ne=ee*he;for(let j=ae==1?_:m;j>=_&&j<=m;j+=ae){let ie=S[j];if(ie==null)continue;if(w!=null){let He=w[j]??0;if(ie-He==0)continue;ue=A(He,F,C,E)}let Se=b.distr!=2||c!=null?M[j]:j,ye=L(Se,b,x,U),Ae=A(yt(ie,oe),F,C,E),Ze=V(ye-ve),pe=V(En(Ae,ue)),xe=V(ai(Ae,ue)),Oe=pe-xe;if(ie!=null){let He=ie<0?ne:Q,Ee=ie<0?Q:ne;ht?(ke>0&&G[j]!=null&&ce(Kt.get(G[j]),Ze,xe+Bn(ke/2),he,En(0,Oe-ke),He,Ee),Je[j]!=null&&ce(ut.get(Je[j]),Ze,xe+Bn(ke/2),he,En(0,Oe-ke),He,Ee)):ce(I,Ze,xe+Bn(ke/2),he,En(0,Oe-ke),He,Ee),_e(p,g,j,Ze-ke/2,xe,he+ke,Oe)}}return ke>0?Ne.stroke=ht?Kt:I:ht||(Ne._fill=f.width==0?f._fill:f._stroke??f._fill,Ne.width=0),Ne.fill=ht?ut:I,Ne})}function t_(i,e){const t=yt(e?.alignGaps,0);return(n,s,o,r)=>Ks(n,s,(a,l,c,h,u,d,p,g,_,m,f)=>{[o,r]=qa(c,o,r);let M=a.pxRound,S=Y=>M(d(Y,h,m,g)),b=Y=>M(p(Y,u,f,_)),F,L,A;h.ori==0?(F=Za,A=Xo,L=Dp):(F=Ja,A=jo,L=Ip);const U=h.dir*(h.ori==0?1:-1);let E=S(l[U==1?o:r]),x=E,C=[],V=[];for(let Y=U==1?o:r;Y>=o&&Y<=r;Y+=U)if(c[Y]!=null){let ae=l[Y],ce=S(ae);C.push(x=ce),V.push(b(c[Y]))}const O={stroke:i(C,V,F,A,L,M),fill:null,clip:null,band:null,gaps:null,flags:Fo},q=O.stroke;let[$,X]=Ah(n,s);if(a.fill!=null||$!=0){let Y=O.fill=new Path2D(q),ee=a.fillTo(n,s,a.min,a.max,$),ae=b(ee);A(Y,x,ae),A(Y,E,ae)}if(!a.spanGaps){let Y=[];Y.push(...Rh(l,c,o,r,U,S,t)),O.gaps=Y=a.gaps(n,s,o,r,Y),O.clip=Ka(Y,h.ori,g,_,m,f)}return X!=0&&(O.band=X==2?[Vi(n,s,o,r,q,-1),Vi(n,s,o,r,q,1)]:Vi(n,s,o,r,q,X)),O})}function n_(i){return t_(i_,i)}function i_(i,e,t,n,s,o){const r=i.length;if(r<2)return null;const a=new Path2D;if(t(a,i[0],e[0]),r==2)n(a,i[1],e[1]);else{let l=Array(r),c=Array(r-1),h=Array(r-1),u=Array(r-1);for(let d=0;d<r-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<r-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[r-1]=c[r-2];for(let d=0;d<r-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}const _c=new Set;function ad(){for(let i of _c)i.syncRect(!0)}qo&&(Bs(Fg,Po,ad),Bs(Og,Po,ad,!0),Bs(Ca,Po,()=>{bn.pxRatio=St}));const s_=Fp(),o_=kp();function ld(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((o,r)=>vc(o,r,e,t))}function r_(i,e){return i.map((t,n)=>n==0?{}:jt({},e,t))}function vc(i,e,t,n){return jt({},e==0?t:n,i)}function Op(i,e,t){return e==null?ko:[e,t]}const a_=Op;function l_(i,e,t){return e==null?ko:Pa(e,t,yh,!0)}function zp(i,e,t,n){return e==null?ko:Xa(e,t,i.scales[n].log,!1)}const c_=zp;function Bp(i,e,t,n){return e==null?ko:bh(e,t,i.scales[n].log,!1)}const h_=Bp;function u_(i,e,t,n,s){let o=En(Bu(i),Bu(e)),r=e-i,a=ri(s/n*r,t);do{let l=t[a],c=n*l/r;if(c>=s&&o+(l<5?ds.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function cd(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=Jt((t=+s)*St))+"px"),[i,e,t]}function d_(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Lt(e[2]*St,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function bn(i,e,t){const n={mode:yt(i.mode,1)},s=n.mode;function o(v,y,P,k){let z=y.valToPct(v);return k+P*(y.dir==-1?1-z:z)}function r(v,y,P,k){let z=y.valToPct(v);return k+P*(y.dir==-1?z:1-z)}function a(v,y,P,k){return y.ori==0?o(v,y,P,k):r(v,y,P,k)}n.valToPosH=o,n.valToPosV=r;let l=!1;n.status=0;const c=n.root=Xn(bg);if(i.id!=null&&(c.id=i.id),On(c,i.class),i.title){let v=Xn(Mg,c);v.textContent=i.title}const h=si("canvas"),u=n.ctx=h.getContext("2d"),d=Xn(Sg,c);Bs("click",d,v=>{v.target===g&&(Dt!=so||zt!=oo)&&un.click(n,v)},!0);const p=n.under=Xn(wg,d);d.appendChild(h);const g=n.over=Xn(Eg,d);i=Uo(i);const _=+yt(i.pxAlign,1),m=od(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});const f=i.ms||.001,M=n.series=s==1?ld(i.series||[],Ju,id,!1):r_(i.series||[null],nd),S=n.axes=ld(i.axes||[],Zu,ed,!0),b=n.scales={},F=n.bands=i.bands||[];F.forEach(v=>{v.fill=ct(v.fill||null),v.dir=yt(v.dir,-1)});const L=s==2?M[1].facets[0].scale:M[0].scale,A={axes:sg,series:Vn},U=(i.drawOrder||["axes","series"]).map(v=>A[v]);function E(v){const y=v.distr==3?P=>Hi(P>0?P:v.clamp(n,P,v.min,v.max,v.key)):v.distr==4?P=>bl(P,v.asinh):v.distr==100?P=>v.fwd(P):P=>P;return P=>{let k=y(P),{_min:z,_max:J}=v,re=J-z;return(k-z)/re}}function x(v){let y=b[v];if(y==null){let P=(i.scales||xr)[v]||xr;if(P.from!=null){x(P.from);let k=jt({},b[P.from],P,{key:v});k.valToPct=E(k),b[v]=k}else{y=b[v]=jt({},v==L?Rp:j0,P),y.key=v;let k=y.time,z=y.range,J=ss(z);if((v!=L||s==2&&!k)&&(J&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?Fu:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?Fu:{mode:1,hard:z[1],soft:z[1]}},J=!1),!J&&Ya(z))){let re=z;z=(de,ge,Pe)=>ge==null?ko:Pa(ge,Pe,re)}y.range=ct(z||(k?a_:v==L?y.distr==3?c_:y.distr==4?h_:Op:y.distr==3?zp:y.distr==4?Bp:l_)),y.auto=ct(J?!1:y.auto),y.clamp=ct(y.clamp||X0),y._min=y._max=null,y.valToPct=E(y)}}}x("x"),x("y"),s==1&&M.forEach(v=>{x(v.scale)}),S.forEach(v=>{x(v.scale)});for(let v in i.scales)x(v);const C=b[L],V=C.distr;let O,q;C.ori==0?(On(c,yg),O=o,q=r):(On(c,xg),O=r,q=o);const $={};for(let v in b){let y=b[v];(y.min!=null||y.max!=null)&&($[v]={min:y.min,max:y.max},y.min=y.max=null)}const X=i.tzDate||(v=>new Date(Jt(v/f))),Y=i.fmtDate||Sh,ee=f==1?y0(X):S0(X),ae=ju(X,Xu(f==1?b0:M0,Y)),ce=Ku(X,Yu(E0,Y)),_e=[],be=n.legend=jt({},R0,i.legend),me=n.cursor=jt({},I0,{drag:{y:s==2}},i.cursor),oe=be.show,ue=me.show,ve=be.markers;be.idxs=_e,ve.width=ct(ve.width),ve.dash=ct(ve.dash),ve.stroke=ct(ve.stroke),ve.fill=ct(ve.fill);let he,Ie,Be,ke=[],ht=[],Je,ut=!1,G={};if(be.live){const v=M[1]?M[1].values:null;ut=v!=null,Je=ut?v(n,1,0):{_:0};for(let y in Je)G[y]=_h}if(oe)if(he=si("table",Lg,c),Be=si("tbody",null,he),be.mount(n,he),ut){Ie=si("thead",null,he,Be);let v=si("tr",null,Ie);si("th",null,v);for(var Kt in Je)si("th",wu,v).textContent=Kt}else On(he,Dg),be.live&&On(he,Ng);const et={show:!0},nt={show:!1};function We(v,y){if(y==0&&(ut||!be.live||s==2))return ko;let P=[],k=si("tr",Ig,Be,Be.childNodes[y]);On(k,v.class),v.show||On(k,Is);let z=si("th",null,k);if(ve.show){let de=Xn(kg,z);if(y>0){let ge=ve.width(n,y);ge&&(de.style.border=ge+"px "+ve.dash(n,y)+" "+ve.stroke(n,y)),de.style.background=ve.fill(n,y)}}let J=Xn(wu,z);v.label instanceof HTMLElement?J.appendChild(v.label):J.textContent=v.label,y>0&&(ve.show||(J.style.color=v.width>0?ve.stroke(n,y):ve.fill(n,y)),Ne("click",z,de=>{if(me._lock)return;Zt(de);let ge=M.indexOf(v);if((de.ctrlKey||de.metaKey)!=be.isolate){let Pe=M.some((Le,De)=>De>0&&De!=ge&&Le.show);M.forEach((Le,De)=>{De>0&&pi(De,Pe?De==ge?et:nt:et,!0,$t.setSeries)})}else pi(ge,{show:!v.show},!0,$t.setSeries)},!1),Ai&&Ne(Ru,z,de=>{me._lock||(Zt(de),pi(M.indexOf(v),ao,!0,$t.setSeries))},!1));for(var re in Je){let de=si("td",Ug,k);de.textContent="--",P.push(de)}return[k,P]}const pt=new Map;function Ne(v,y,P,k=!0){const z=pt.get(y)||{},J=me.bind[v](n,y,P,k);J&&(Bs(v,y,z[v]=J),pt.set(y,z))}function I(v,y,P){const k=pt.get(y)||{};for(let z in k)(v==null||z==v)&&(dc(z,y,k[z]),delete k[z]);v==null&&pt.delete(y)}let w=0,Q=0,ne=0,j=0,ie=0,Se=0,ye=ie,Ae=Se,Ze=ne,pe=j,xe=0,Oe=0,He=0,Ee=0;n.bbox={};let ot=!1,Ye=!1,mt=!1,H=!1,Me=!1,se=!1;function le(v,y,P){(P||v!=n.width||y!=n.height)&&Re(v,y),eo(!1),mt=!0,Ye=!0,to()}function Re(v,y){n.width=w=ne=v,n.height=Q=j=y,ie=Se=0,nn(),xt();let P=n.bbox;xe=P.left=Ls(ie*St,.5),Oe=P.top=Ls(Se*St,.5),He=P.width=Ls(ne*St,.5),Ee=P.height=Ls(j*St,.5)}const Ce=3;function Qe(){let v=!1,y=0;for(;!v;){y++;let P=ng(y),k=ig(y);v=y==Ce||P&&k,v||(Re(n.width,n.height),Ye=!0)}}function Ft({width:v,height:y}){le(v,y)}n.setSize=Ft;function nn(){let v=!1,y=!1,P=!1,k=!1;S.forEach((z,J)=>{if(z.show&&z._show){let{side:re,_size:de}=z,ge=re%2,Pe=z.label!=null?z.labelSize:0,Le=de+Pe;Le>0&&(ge?(ne-=Le,re==3?(ie+=Le,k=!0):P=!0):(j-=Le,re==0?(Se+=Le,v=!0):y=!0))}}),ui[0]=v,ui[1]=P,ui[2]=y,ui[3]=k,ne-=T[1]+T[3],ie+=T[3],j-=T[2]+T[0],Se+=T[0]}function xt(){let v=ie+ne,y=Se+j,P=ie,k=Se;function z(J,re){switch(J){case 1:return v+=re,v-re;case 2:return y+=re,y-re;case 3:return P-=re,P+re;case 0:return k-=re,k+re}}S.forEach((J,re)=>{if(J.show&&J._show){let de=J.side;J._pos=z(de,J._size),J.label!=null&&(J._lpos=z(de,J.labelSize))}})}if(me.dataIdx==null){let v=me.hover,y=v.skip=new Set(v.skip??[]);y.add(void 0);let P=v.prox=ct(v.prox),k=v.bias??=0;me.dataIdx=(z,J,re,de)=>{if(J==0)return re;let ge=re,Pe=P(z,J,re,de)??Pt,Le=Pe>=0&&Pe<Pt,De=C.ori==0?ne:j,Ke=me.left,Mt=e[0],bt=e[J];if(y.has(bt[re])){ge=null;let rt=null,Xe=null,Ge;if(k==0||k==-1)for(Ge=re;rt==null&&Ge-- >0;)y.has(bt[Ge])||(rt=Ge);if(k==0||k==1)for(Ge=re;Xe==null&&Ge++<bt.length;)y.has(bt[Ge])||(Xe=Ge);if(rt!=null||Xe!=null)if(Le){let kt=rt==null?-1/0:O(Mt[rt],C,De,0),Vt=Xe==null?1/0:O(Mt[Xe],C,De,0),ln=Ke-kt,At=Vt-Ke;ln<=At?ln<=Pe&&(ge=rt):At<=Pe&&(ge=Xe)}else ge=Xe==null?rt:rt==null?Xe:re-rt<=Xe-re?rt:Xe}else Le&&Qt(Ke-O(Mt[re],C,De,0))>Pe&&(ge=null);return ge}}const Zt=v=>{me.event=v};me.idxs=_e,me._lock=!1;let Nt=me.points;Nt.show=ct(Nt.show),Nt.size=ct(Nt.size),Nt.stroke=ct(Nt.stroke),Nt.width=ct(Nt.width),Nt.fill=ct(Nt.fill);const Nn=n.focus=jt({},i.focus||{alpha:.3},me.focus),Ai=Nn.prox>=0,An=Ai&&Nt.one;let mn=[],Ri=[],Ci=[];function vs(v,y){let P=Nt.show(n,y);if(P instanceof HTMLElement)return On(P,Pg),On(P,v.class),vi(P,-10,-10,ne,j),g.insertBefore(P,mn[y]),P}function Qo(v,y){if(s==1||y>0){let P=s==1&&b[v.scale].time,k=v.value;v.value=P?Gu(k)?Ku(X,Yu(k,Y)):k||ce:k||W0,v.label=v.label||(P?U0:k0)}if(An||y>0){v.width=v.width==null?1:v.width,v.paths=v.paths||s_||jg,v.fillTo=ct(v.fillTo||Y0),v.pxAlign=+yt(v.pxAlign,_),v.pxRound=od(v.pxAlign),v.stroke=ct(v.stroke||null),v.fill=ct(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let P=$0(En(1,v.width),1),k=v.points=jt({},{size:P,width:En(1,P*.2),stroke:v.stroke,space:P*2,paths:o_,_stroke:null,_fill:null},v.points);k.show=ct(k.show),k.filter=ct(k.filter),k.fill=ct(k.fill),k.stroke=ct(k.stroke),k.paths=ct(k.paths),k.pxAlign=v.pxAlign}if(oe){let P=We(v,y);ke.splice(y,0,P[0]),ht.splice(y,0,P[1]),be.values.push(null)}if(ue){_e.splice(y,0,null);let P=null;An?y==0&&(P=vs(v,y)):y>0&&(P=vs(v,y)),mn.splice(y,0,P),Ri.splice(y,0,0),Ci.splice(y,0,0)}an("addSeries",y)}function Js(v,y){y=y??M.length,v=s==1?vc(v,y,Ju,id):vc(v,y,{},nd),M.splice(y,0,v),Qo(M[y],y)}n.addSeries=Js;function kr(v){if(M.splice(v,1),oe){be.values.splice(v,1),ht.splice(v,1);let y=ke.splice(v,1)[0];I(null,y.firstChild),y.remove()}ue&&(_e.splice(v,1),mn.splice(v,1)[0].remove(),Ri.splice(v,1),Ci.splice(v,1)),an("delSeries",v)}n.delSeries=kr;const ui=[!1,!1,!1,!1];function sl(v,y){if(v._show=v.show,v.show){let P=v.side%2,k=b[v.scale];k==null&&(v.scale=P?M[1].scale:L,k=b[v.scale]);let z=k.time;v.size=ct(v.size),v.space=ct(v.space),v.rotate=ct(v.rotate),ss(v.incrs)&&v.incrs.forEach(re=>{!ds.has(re)&&ds.set(re,cp(re))}),v.incrs=ct(v.incrs||(k.distr==2?g0:z?f==1?v0:x0:Ns)),v.splits=ct(v.splits||(z&&k.distr==1?ee:k.distr==3?pc:k.distr==4?z0:O0)),v.stroke=ct(v.stroke),v.grid.stroke=ct(v.grid.stroke),v.ticks.stroke=ct(v.ticks.stroke),v.border.stroke=ct(v.border.stroke);let J=v.values;v.values=ss(J)&&!ss(J[0])?ct(J):z?ss(J)?ju(X,Xu(J,Y)):Gu(J)?w0(X,J):J||ae:J||F0,v.filter=ct(v.filter||(k.distr>=3&&k.log==10?V0:k.distr==3&&k.log==2?G0:ap)),v.font=cd(v.font),v.labelFont=cd(v.labelFont),v._size=v.size(n,null,y,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(ui[y]=!0,v._el=Xn(Tg,d))}}function bs(v,y,P,k){let[z,J,re,de]=P,ge=y%2,Pe=0;return ge==0&&(de||J)&&(Pe=y==0&&!z||y==2&&!re?Jt(Zu.size/3):0),ge==1&&(z||re)&&(Pe=y==1&&!J||y==3&&!de?Jt(ed.size/2):0),Pe}const Ur=n.padding=(i.padding||[bs,bs,bs,bs]).map(v=>ct(yt(v,bs))),T=n._padding=Ur.map((v,y)=>v(n,y,ui,0));let B,K=null,Z=null;const W=s==1?M[0].idxs:null;let fe=null,we=!1;function ze(v,y){if(e=v??[],n.data=n._data=e,s==2){B=0;for(let P=1;P<M.length;P++)B+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),fe=e[0],B=fe.length;let P=e;if(V==2){P=e.slice();let k=P[0]=Array(B);for(let z=0;z<B;z++)k[z]=z}n._data=e=P}if(eo(!0),an("setData"),V==2&&(mt=!0),y!==!1){let P=C;P.auto(n,we)?Ue():Yi(L,P.min,P.max),H=H||me.left>=0,se=!0,to()}}n.setData=ze;function Ue(){we=!0;let v,y;s==1&&(B>0?(K=W[0]=0,Z=W[1]=B-1,v=e[0][K],y=e[0][Z],V==2?(v=K,y=Z):v==y&&(V==3?[v,y]=Xa(v,v,C.log,!1):V==4?[v,y]=bh(v,v,C.log,!1):C.time?y=v+Jt(86400/f):[v,y]=Pa(v,y,yh,!0))):(K=W[0]=v=null,Z=W[1]=y=null)),Yi(L,v,y)}let qe,je,Fe,lt,wt,Tt,sn,dt,Ve,Ot;function gt(v,y,P,k,z,J){v??=Tu,P??=Mh,k??="butt",z??=Tu,J??="round",v!=qe&&(u.strokeStyle=qe=v),z!=je&&(u.fillStyle=je=z),y!=Fe&&(u.lineWidth=Fe=y),J!=wt&&(u.lineJoin=wt=J),k!=Tt&&(u.lineCap=Tt=k),P!=lt&&u.setLineDash(lt=P)}function Rn(v,y,P,k){y!=je&&(u.fillStyle=je=y),v!=sn&&(u.font=sn=v),P!=dt&&(u.textAlign=dt=P),k!=Ve&&(u.textBaseline=Ve=k)}function di(v,y,P,k,z=0){if(k.length>0&&v.auto(n,we)&&(y==null||y.min==null)){let J=yt(K,0),re=yt(Z,k.length-1),de=P.min==null?Vg(k,J,re,z,v.distr==3):[P.min,P.max];v.min=ai(v.min,P.min=de[0]),v.max=En(v.max,P.max=de[1])}}const gn={min:null,max:null};function ys(){for(let k in b){let z=b[k];$[k]==null&&(z.min==null||$[L]!=null&&z.auto(n,we))&&($[k]=gn)}for(let k in b){let z=b[k];$[k]==null&&z.from!=null&&$[z.from]!=null&&($[k]=gn)}$[L]!=null&&eo(!0);let v={};for(let k in $){let z=$[k];if(z!=null){let J=v[k]=Uo(b[k],Zg);if(z.min!=null)jt(J,z);else if(k!=L||s==2)if(B==0&&J.from==null){let re=J.range(n,null,null,k);J.min=re[0],J.max=re[1]}else J.min=Pt,J.max=-Pt}}if(B>0){M.forEach((k,z)=>{if(s==1){let J=k.scale,re=$[J];if(re==null)return;let de=v[J];if(z==0){let ge=de.range(n,de.min,de.max,J);de.min=ge[0],de.max=ge[1],K=ri(de.min,e[0]),Z=ri(de.max,e[0]),Z-K>1&&(e[0][K]<de.min&&K++,e[0][Z]>de.max&&Z--),k.min=fe[K],k.max=fe[Z]}else k.show&&k.auto&&di(de,re,k,e[z],k.sorted);k.idxs[0]=K,k.idxs[1]=Z}else if(z>0&&k.show&&k.auto){let[J,re]=k.facets,de=J.scale,ge=re.scale,[Pe,Le]=e[z],De=v[de],Ke=v[ge];De!=null&&di(De,$[de],J,Pe,J.sorted),Ke!=null&&di(Ke,$[ge],re,Le,re.sorted),k.min=re.min,k.max=re.max}});for(let k in v){let z=v[k],J=$[k];if(z.from==null&&(J==null||J.min==null)){let re=z.range(n,z.min==Pt?null:z.min,z.max==-Pt?null:z.max,k);z.min=re[0],z.max=re[1]}}}for(let k in v){let z=v[k];if(z.from!=null){let J=v[z.from];if(J.min==null)z.min=z.max=null;else{let re=z.range(n,J.min,J.max,k);z.min=re[0],z.max=re[1]}}}let y={},P=!1;for(let k in v){let z=v[k],J=b[k];if(J.min!=z.min||J.max!=z.max){J.min=z.min,J.max=z.max;let re=J.distr;J._min=re==3?Hi(J.min):re==4?bl(J.min,J.asinh):re==100?J.fwd(J.min):J.min,J._max=re==3?Hi(J.max):re==4?bl(J.max,J.asinh):re==100?J.fwd(J.max):J.max,y[k]=P=!0}}if(P){M.forEach((k,z)=>{s==2?z>0&&y.y&&(k._paths=null):y[k.scale]&&(k._paths=null)});for(let k in y)mt=!0,an("setScale",k);ue&&me.left>=0&&(H=se=!0)}for(let k in $)$[k]=null}function Ct(v){let y=fc(K-1,0,B-1),P=fc(Z+1,0,B-1);for(;v[y]==null&&y>0;)y--;for(;v[P]==null&&P<B-1;)P++;return[y,P]}function Vn(){if(B>0){let v=M.some(y=>y._focus)&&Ot!=Nn.alpha;v&&(u.globalAlpha=Ot=Nn.alpha),M.forEach((y,P)=>{if(P>0&&y.show&&(Xi(P,!1),Xi(P,!0),y._paths==null)){let k=Ot;Ot!=y.alpha&&(u.globalAlpha=Ot=y.alpha);let z=s==2?[0,e[P][0].length-1]:Ct(e[P]);y._paths=y.paths(n,P,z[0],z[1]),Ot!=k&&(u.globalAlpha=Ot=k)}}),M.forEach((y,P)=>{if(P>0&&y.show){let k=Ot;Ot!=y.alpha&&(u.globalAlpha=Ot=y.alpha),y._paths!=null&&yn(P,!1);{let z=y._paths!=null?y._paths.gaps:null,J=y.points.show(n,P,K,Z,z),re=y.points.filter(n,P,J,z);(J||re)&&(y.points._paths=y.points.paths(n,P,K,Z,re),yn(P,!0))}Ot!=k&&(u.globalAlpha=Ot=k),an("drawSeries",P)}}),v&&(u.globalAlpha=Ot=1)}}function Xi(v,y){let P=y?M[v].points:M[v];P._stroke=P.stroke(n,v),P._fill=P.fill(n,v)}function yn(v,y){let P=y?M[v].points:M[v],{stroke:k,fill:z,clip:J,flags:re,_stroke:de=P._stroke,_fill:ge=P._fill,_width:Pe=P.width}=P._paths;Pe=Lt(Pe*St,3);let Le=null,De=Pe%2/2;y&&ge==null&&(ge=Pe>0?"#fff":de);let Ke=P.pxAlign==1&&De>0;if(Ke&&u.translate(De,De),!y){let Mt=xe-Pe/2,bt=Oe-Pe/2,rt=He+Pe,Xe=Ee+Pe;Le=new Path2D,Le.rect(Mt,bt,rt,Xe)}y?Qs(de,Pe,P.dash,P.cap,ge,k,z,re,J):fi(v,de,Pe,P.dash,P.cap,ge,k,z,re,Le,J),Ke&&u.translate(-De,-De)}function fi(v,y,P,k,z,J,re,de,ge,Pe,Le){let De=!1;ge!=0&&F.forEach((Ke,Mt)=>{if(Ke.series[0]==v){let bt=M[Ke.series[1]],rt=e[Ke.series[1]],Xe=(bt._paths||xr).band;ss(Xe)&&(Xe=Ke.dir==1?Xe[0]:Xe[1]);let Ge,kt=null;bt.show&&Xe&&Wg(rt,K,Z)?(kt=Ke.fill(n,Mt)||J,Ge=bt._paths.clip):Xe=null,Qs(y,P,k,z,kt,re,de,ge,Pe,Le,Ge,Xe),De=!0}}),De||Qs(y,P,k,z,J,re,de,ge,Pe,Le)}const Jn=Fo|gc;function Qs(v,y,P,k,z,J,re,de,ge,Pe,Le,De){gt(v,y,P,k,z),(ge||Pe||De)&&(u.save(),ge&&u.clip(ge),Pe&&u.clip(Pe)),De?(de&Jn)==Jn?(u.clip(De),Le&&u.clip(Le),Or(z,re),Fr(v,J,y)):de&gc?(Or(z,re),u.clip(De),Fr(v,J,y)):de&Fo&&(u.save(),u.clip(De),Le&&u.clip(Le),Or(z,re),u.restore(),Fr(v,J,y)):(Or(z,re),Fr(v,J,y)),(ge||Pe||De)&&u.restore()}function Fr(v,y,P){P>0&&(y instanceof Map?y.forEach((k,z)=>{u.strokeStyle=qe=z,u.stroke(k)}):y!=null&&v&&u.stroke(y))}function Or(v,y){y instanceof Map?y.forEach((P,k)=>{u.fillStyle=je=k,u.fill(P)}):y!=null&&v&&u.fill(y)}function tg(v,y,P,k){let z=S[v],J;if(k<=0)J=[0,0];else{let re=z._space=z.space(n,v,y,P,k),de=z._incrs=z.incrs(n,v,y,P,k,re);J=u_(y,P,de,k,re)}return z._found=J}function ol(v,y,P,k,z,J,re,de,ge,Pe){let Le=re%2/2;_==1&&u.translate(Le,Le),gt(de,re,ge,Pe,de),u.beginPath();let De,Ke,Mt,bt,rt=z+(k==0||k==3?-J:J);P==0?(Ke=z,bt=rt):(De=z,Mt=rt);for(let Xe=0;Xe<v.length;Xe++)y[Xe]!=null&&(P==0?De=Mt=v[Xe]:Ke=bt=v[Xe],u.moveTo(De,Ke),u.lineTo(Mt,bt));u.stroke(),_==1&&u.translate(-Le,-Le)}function ng(v){let y=!0;return S.forEach((P,k)=>{if(!P.show)return;let z=b[P.scale];if(z.min==null){P._show&&(y=!1,P._show=!1,eo(!1));return}else P._show||(y=!1,P._show=!0,eo(!1));let J=P.side,re=J%2,{min:de,max:ge}=z,[Pe,Le]=tg(k,de,ge,re==0?ne:j);if(Le==0)return;let De=z.distr==2,Ke=P._splits=P.splits(n,k,de,ge,Pe,Le,De),Mt=z.distr==2?Ke.map(Ge=>fe[Ge]):Ke,bt=z.distr==2?fe[Ke[1]]-fe[Ke[0]]:Pe,rt=P._values=P.values(n,P.filter(n,Mt,k,Le,bt),k,Le,bt);P._rotate=J==2?P.rotate(n,rt,k,Le):0;let Xe=P._size;P._size=Yn(P.size(n,rt,k,v)),Xe!=null&&P._size!=Xe&&(y=!1)}),y}function ig(v){let y=!0;return Ur.forEach((P,k)=>{let z=P(n,k,ui,v);z!=T[k]&&(y=!1),T[k]=z}),y}function sg(){for(let v=0;v<S.length;v++){let y=S[v];if(!y.show||!y._show)continue;let P=y.side,k=P%2,z,J,re=y.stroke(n,v),de=P==0||P==3?-1:1,[ge,Pe]=y._found;if(y.label!=null){let Mn=y.labelGap*de,kn=Jt((y._lpos+Mn)*St);Rn(y.labelFont[0],re,"center",P==2?"top":Eu),u.save(),k==1?(z=J=0,u.translate(kn,Jt(Oe+Ee/2)),u.rotate((P==3?-ba:ba)/2)):(z=Jt(xe+He/2),J=kn);let Ss=op(y.label)?y.label(n,v,ge,Pe):y.label;u.fillText(Ss,z,J),u.restore()}if(Pe==0)continue;let Le=b[y.scale],De=k==0?He:Ee,Ke=k==0?xe:Oe,Mt=y._splits,bt=Le.distr==2?Mt.map(Mn=>fe[Mn]):Mt,rt=Le.distr==2?fe[Mt[1]]-fe[Mt[0]]:ge,Xe=y.ticks,Ge=y.border,kt=Xe.show?Xe.size:0,Vt=Jt(kt*St),ln=Jt((y.alignTo==2?y._size-kt-y.gap:y.gap)*St),At=y._rotate*-ba/180,Gt=m(y._pos*St),Dn=(Vt+ln)*de,xn=Gt+Dn;J=k==0?xn:0,z=k==1?xn:0;let Gn=y.font[0],Qn=y.align==1?co:y.align==2?gl:At>0?co:At<0?gl:k==0?"center":P==3?gl:co,gi=At||k==1?"middle":P==2?"top":Eu;Rn(Gn,re,Qn,gi);let In=y.font[1]*y.lineGap,Wn=Mt.map(Mn=>m(a(Mn,Le,De,Ke))),ei=y._values;for(let Mn=0;Mn<ei.length;Mn++){let kn=ei[Mn];if(kn!=null){k==0?z=Wn[Mn]:J=Wn[Mn],kn=""+kn;let Ss=kn.indexOf(`
`)==-1?[kn]:kn.split(/\n/gm);for(let Sn=0;Sn<Ss.length;Sn++){let Su=Ss[Sn];At?(u.save(),u.translate(z,J+Sn*In),u.rotate(At),u.fillText(Su,0,0),u.restore()):u.fillText(Su,z,J+Sn*In)}}}Xe.show&&ol(Wn,Xe.filter(n,bt,v,Pe,rt),k,P,Gt,Vt,Lt(Xe.width*St,3),Xe.stroke(n,v),Xe.dash,Xe.cap);let _i=y.grid;_i.show&&ol(Wn,_i.filter(n,bt,v,Pe,rt),k,k==0?2:1,k==0?Oe:xe,k==0?Ee:He,Lt(_i.width*St,3),_i.stroke(n,v),_i.dash,_i.cap),Ge.show&&ol([Gt],[1],k==0?1:0,k==0?1:2,k==1?Oe:xe,k==1?Ee:He,Lt(Ge.width*St,3),Ge.stroke(n,v),Ge.dash,Ge.cap)}an("drawAxes")}function eo(v){M.forEach((y,P)=>{P>0&&(y._paths=null,v&&(s==1?(y.min=null,y.max=null):y.facets.forEach(k=>{k.min=null,k.max=null})))})}let zr=!1,rl=!1,er=[];function og(){rl=!1;for(let v=0;v<er.length;v++)an(...er[v]);er.length=0}function to(){zr||(s0(ou),zr=!0)}function rg(v,y=!1){zr=!0,rl=y,v(n),ou(),y&&er.length>0&&queueMicrotask(og)}n.batch=rg;function ou(){if(ot&&(ys(),ot=!1),mt&&(Qe(),mt=!1),Ye){if(Ut(p,co,ie),Ut(p,"top",Se),Ut(p,pr,ne),Ut(p,mr,j),Ut(g,co,ie),Ut(g,"top",Se),Ut(g,pr,ne),Ut(g,mr,j),Ut(d,pr,w),Ut(d,mr,Q),h.width=Jt(w*St),h.height=Jt(Q*St),S.forEach(({_el:v,_show:y,_size:P,_pos:k,side:z})=>{if(v!=null)if(y){let J=z===3||z===0?P:0,re=z%2==1;Ut(v,re?"left":"top",k-J),Ut(v,re?"width":"height",P),Ut(v,re?"top":"left",re?Se:ie),Ut(v,re?"height":"width",re?j:ne),uc(v,Is)}else On(v,Is)}),qe=je=Fe=wt=Tt=sn=dt=Ve=lt=null,Ot=1,ir(!0),ie!=ye||Se!=Ae||ne!=Ze||j!=pe){eo(!1);let v=ne/Ze,y=j/pe;if(ue&&!H&&me.left>=0){me.left*=v,me.top*=y,no&&vi(no,Jt(me.left),0,ne,j),io&&vi(io,0,Jt(me.top),ne,j);for(let P=0;P<mn.length;P++){let k=mn[P];k!=null&&(Ri[P]*=v,Ci[P]*=y,vi(k,Yn(Ri[P]),Yn(Ci[P]),ne,j))}}if(It.show&&!Me&&It.left>=0&&It.width>0){It.left*=v,It.width*=v,It.top*=y,It.height*=y;for(let P in dl)Ut(ro,P,It[P])}ye=ie,Ae=Se,Ze=ne,pe=j}an("setSize"),Ye=!1}w>0&&Q>0&&(u.clearRect(0,0,h.width,h.height),an("drawClear"),U.forEach(v=>v()),an("draw")),It.show&&Me&&(Br(It),Me=!1),ue&&H&&(Ms(null,!0,!1),H=!1),be.show&&be.live&&se&&(hl(),se=!1),l||(l=!0,n.status=1,an("ready")),we=!1,zr=!1}n.redraw=(v,y)=>{mt=y||!1,v!==!1?Yi(L,C.min,C.max):to()};function al(v,y){let P=b[v];if(P.from==null){if(B==0){let k=P.range(n,y.min,y.max,v);y.min=k[0],y.max=k[1]}if(y.min>y.max){let k=y.min;y.min=y.max,y.max=k}if(B>1&&y.min!=null&&y.max!=null&&y.max-y.min<1e-16)return;v==L&&P.distr==2&&B>0&&(y.min=ri(y.min,e[0]),y.max=ri(y.max,e[0]),y.min==y.max&&y.max++),$[v]=y,ot=!0,to()}}n.setScale=al;let ll,cl,no,io,ru,au,so,oo,lu,cu,Dt,zt,ji=!1;const un=me.drag;let on=un.x,rn=un.y;ue&&(me.x&&(ll=Xn(Rg,g)),me.y&&(cl=Xn(Cg,g)),C.ori==0?(no=ll,io=cl):(no=cl,io=ll),Dt=me.left,zt=me.top);const It=n.select=jt({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),ro=It.show?Xn(Ag,It.over?g:p):null;function Br(v,y){if(It.show){for(let P in v)It[P]=v[P],P in dl&&Ut(ro,P,v[P]);y!==!1&&an("setSelect")}}n.setSelect=Br;function ag(v){if(M[v].show)oe&&uc(ke[v],Is);else if(oe&&On(ke[v],Is),ue){let P=An?mn[0]:mn[v];P!=null&&vi(P,-10,-10,ne,j)}}function Yi(v,y,P){al(v,{min:y,max:P})}function pi(v,y,P,k){y.focus!=null&&dg(v),y.show!=null&&M.forEach((z,J)=>{J>0&&(v==J||v==null)&&(z.show=y.show,ag(J),s==2?(Yi(z.facets[0].scale,null,null),Yi(z.facets[1].scale,null,null)):Yi(z.scale,null,null),to())}),P!==!1&&an("setSeries",v,y),k&&sr("setSeries",n,v,y)}n.setSeries=pi;function lg(v,y){jt(F[v],y)}function cg(v,y){v.fill=ct(v.fill||null),v.dir=yt(v.dir,-1),y=y??F.length,F.splice(y,0,v)}function hg(v){v==null?F.length=0:F.splice(v,1)}n.addBand=cg,n.setBand=lg,n.delBand=hg;function ug(v,y){M[v].alpha=y,ue&&mn[v]!=null&&(mn[v].style.opacity=y),oe&&ke[v]&&(ke[v].style.opacity=y)}let Pi,Ki,xs;const ao={focus:!0};function dg(v){if(v!=xs){let y=v==null,P=Nn.alpha!=1;M.forEach((k,z)=>{if(s==1||z>0){let J=y||z==0||z==v;k._focus=y?null:J,P&&ug(z,J?1:Nn.alpha)}}),xs=v,P&&to()}}oe&&Ai&&Ne(Cu,he,v=>{me._lock||(Zt(v),xs!=null&&pi(null,ao,!0,$t.setSeries))});function mi(v,y,P){let k=b[y];P&&(v=v/St-(k.ori==1?Se:ie));let z=ne;k.ori==1&&(z=j,v=z-v),k.dir==-1&&(v=z-v);let J=k._min,re=k._max,de=v/z,ge=J+(re-J)*de,Pe=k.distr;return Pe==3?Io(10,ge):Pe==4?qg(ge,k.asinh):Pe==100?k.bwd(ge):ge}function fg(v,y){let P=mi(v,L,y);return ri(P,e[0],K,Z)}n.valToIdx=v=>ri(v,e[0]),n.posToIdx=fg,n.posToVal=mi,n.valToPos=(v,y,P)=>b[y].ori==0?o(v,b[y],P?He:ne,P?xe:0):r(v,b[y],P?Ee:j,P?Oe:0),n.setCursor=(v,y,P)=>{Dt=v.left,zt=v.top,Ms(null,y,P)};function hu(v,y){Ut(ro,co,It.left=v),Ut(ro,pr,It.width=y)}function uu(v,y){Ut(ro,"top",It.top=v),Ut(ro,mr,It.height=y)}let tr=C.ori==0?hu:uu,nr=C.ori==1?hu:uu;function pg(){if(oe&&be.live)for(let v=s==2?1:0;v<M.length;v++){if(v==0&&ut)continue;let y=be.values[v],P=0;for(let k in y)ht[v][P++].firstChild.nodeValue=y[k]}}function hl(v,y){if(v!=null&&(v.idxs?v.idxs.forEach((P,k)=>{_e[k]=P}):Kg(v.idx)||_e.fill(v.idx),be.idx=_e[0]),oe&&be.live){for(let P=0;P<M.length;P++)(P>0||s==1&&!ut)&&mg(P,_e[P]);pg()}se=!1,y!==!1&&an("setLegend")}n.setLegend=hl;function mg(v,y){let P=M[v],k=v==0&&V==2?fe:e[v],z;ut?z=P.values(n,v,y)??G:(z=P.value(n,y==null?null:k[y],v,y),z=z==null?G:{_:z}),be.values[v]=z}function Ms(v,y,P){lu=Dt,cu=zt,[Dt,zt]=me.move(n,Dt,zt),me.left=Dt,me.top=zt,ue&&(no&&vi(no,Jt(Dt),0,ne,j),io&&vi(io,0,Jt(zt),ne,j));let k,z=K>Z;Pi=Pt,Ki=null;let J=C.ori==0?ne:j,re=C.ori==1?ne:j;if(Dt<0||B==0||z){k=me.idx=null;for(let de=0;de<M.length;de++){let ge=mn[de];ge!=null&&vi(ge,-10,-10,ne,j)}Ai&&pi(null,ao,!0,v==null&&$t.setSeries),be.live&&(_e.fill(k),se=!0)}else{let de,ge,Pe;s==1&&(de=C.ori==0?Dt:zt,ge=mi(de,L),k=me.idx=ri(ge,e[0],K,Z),Pe=O(e[0][k],C,J,0));let Le=-10,De=-10,Ke=0,Mt=0,bt=!0,rt="",Xe="";for(let Ge=s==2?1:0;Ge<M.length;Ge++){let kt=M[Ge],Vt=_e[Ge],ln=Vt==null?null:s==1?e[Ge][Vt]:e[Ge][1][Vt],At=me.dataIdx(n,Ge,k,ge),Gt=At==null?null:s==1?e[Ge][At]:e[Ge][1][At];if(se=se||Gt!=ln||At!=Vt,_e[Ge]=At,Ge>0&&kt.show){let Dn=At==null?-10:At==k?Pe:O(s==1?e[0][At]:e[Ge][0][At],C,J,0),xn=Gt==null?-10:q(Gt,s==1?b[kt.scale]:b[kt.facets[1].scale],re,0);if(Ai&&Gt!=null){let Gn=C.ori==1?Dt:zt,Qn=Qt(Nn.dist(n,Ge,At,xn,Gn));if(Qn<Pi){let gi=Nn.bias;if(gi!=0){let In=mi(Gn,kt.scale),Wn=Gt>=0?1:-1,ei=In>=0?1:-1;ei==Wn&&(ei==1?gi==1?Gt>=In:Gt<=In:gi==1?Gt<=In:Gt>=In)&&(Pi=Qn,Ki=Ge)}else Pi=Qn,Ki=Ge}}if(se||An){let Gn,Qn;C.ori==0?(Gn=Dn,Qn=xn):(Gn=xn,Qn=Dn);let gi,In,Wn,ei,_i,Mn,kn=!0,Ss=Nt.bbox;if(Ss!=null){kn=!1;let Sn=Ss(n,Ge);Wn=Sn.left,ei=Sn.top,gi=Sn.width,In=Sn.height}else Wn=Gn,ei=Qn,gi=In=Nt.size(n,Ge);if(Mn=Nt.fill(n,Ge),_i=Nt.stroke(n,Ge),An)Ge==Ki&&Pi<=Nn.prox&&(Le=Wn,De=ei,Ke=gi,Mt=In,bt=kn,rt=Mn,Xe=_i);else{let Sn=mn[Ge];Sn!=null&&(Ri[Ge]=Wn,Ci[Ge]=ei,Uu(Sn,gi,In,kn),Iu(Sn,Mn,_i),vi(Sn,Yn(Wn),Yn(ei),ne,j))}}}}if(An){let Ge=Nn.prox,kt=xs==null?Pi<=Ge:Pi>Ge||Ki!=xs;if(se||kt){let Vt=mn[0];Vt!=null&&(Ri[0]=Le,Ci[0]=De,Uu(Vt,Ke,Mt,bt),Iu(Vt,rt,Xe),vi(Vt,Yn(Le),Yn(De),ne,j))}}}if(It.show&&ji)if(v!=null){let[de,ge]=$t.scales,[Pe,Le]=$t.match,[De,Ke]=v.cursor.sync.scales,Mt=v.cursor.drag;if(on=Mt._x,rn=Mt._y,on||rn){let{left:bt,top:rt,width:Xe,height:Ge}=v.select,kt=v.scales[De].ori,Vt=v.posToVal,ln,At,Gt,Dn,xn,Gn=de!=null&&Pe(de,De),Qn=ge!=null&&Le(ge,Ke);Gn&&on?(kt==0?(ln=bt,At=Xe):(ln=rt,At=Ge),Gt=b[de],Dn=O(Vt(ln,De),Gt,J,0),xn=O(Vt(ln+At,De),Gt,J,0),tr(ai(Dn,xn),Qt(xn-Dn))):tr(0,J),Qn&&rn?(kt==1?(ln=bt,At=Xe):(ln=rt,At=Ge),Gt=b[ge],Dn=q(Vt(ln,Ke),Gt,re,0),xn=q(Vt(ln+At,Ke),Gt,re,0),nr(ai(Dn,xn),Qt(xn-Dn))):nr(0,re)}else fl()}else{let de=Qt(lu-ru),ge=Qt(cu-au);if(C.ori==1){let Ke=de;de=ge,ge=Ke}on=un.x&&de>=un.dist,rn=un.y&&ge>=un.dist;let Pe=un.uni;Pe!=null?on&&rn&&(on=de>=Pe,rn=ge>=Pe,!on&&!rn&&(ge>de?rn=!0:on=!0)):un.x&&un.y&&(on||rn)&&(on=rn=!0);let Le,De;on&&(C.ori==0?(Le=so,De=Dt):(Le=oo,De=zt),tr(ai(Le,De),Qt(De-Le)),rn||nr(0,re)),rn&&(C.ori==1?(Le=so,De=Dt):(Le=oo,De=zt),nr(ai(Le,De),Qt(De-Le)),on||tr(0,J)),!on&&!rn&&(tr(0,0),nr(0,0))}if(un._x=on,un._y=rn,v==null){if(P){if(Mu!=null){let[de,ge]=$t.scales;$t.values[0]=de!=null?mi(C.ori==0?Dt:zt,de):null,$t.values[1]=ge!=null?mi(C.ori==1?Dt:zt,ge):null}sr(_l,n,Dt,zt,ne,j,k)}if(Ai){let de=P&&$t.setSeries,ge=Nn.prox;xs==null?Pi<=ge&&pi(Ki,ao,!0,de):Pi>ge?pi(null,ao,!0,de):Ki!=xs&&pi(Ki,ao,!0,de)}}se&&(be.idx=k,hl()),y!==!1&&an("setCursor")}let Zi=null;Object.defineProperty(n,"rect",{get(){return Zi==null&&ir(!1),Zi}});function ir(v=!1){v?Zi=null:(Zi=g.getBoundingClientRect(),an("syncRect",Zi))}function du(v,y,P,k,z,J,re){me._lock||ji&&v!=null&&v.movementX==0&&v.movementY==0||(ul(v,y,P,k,z,J,re,!1,v!=null),v!=null?Ms(null,!0,!0):Ms(y,!0,!1))}function ul(v,y,P,k,z,J,re,de,ge){if(Zi==null&&ir(!1),Zt(v),v!=null)P=v.clientX-Zi.left,k=v.clientY-Zi.top;else{if(P<0||k<0){Dt=-10,zt=-10;return}let[Pe,Le]=$t.scales,De=y.cursor.sync,[Ke,Mt]=De.values,[bt,rt]=De.scales,[Xe,Ge]=$t.match,kt=y.axes[0].side%2==1,Vt=C.ori==0?ne:j,ln=C.ori==1?ne:j,At=kt?J:z,Gt=kt?z:J,Dn=kt?k:P,xn=kt?P:k;if(bt!=null?P=Xe(Pe,bt)?a(Ke,b[Pe],Vt,0):-10:P=Vt*(Dn/At),rt!=null?k=Ge(Le,rt)?a(Mt,b[Le],ln,0):-10:k=ln*(xn/Gt),C.ori==1){let Gn=P;P=k,k=Gn}}ge&&(y==null||y.cursor.event.type==_l)&&((P<=1||P>=ne-1)&&(P=Ls(P,ne)),(k<=1||k>=j-1)&&(k=Ls(k,j))),de?(ru=P,au=k,[so,oo]=me.move(n,P,k)):(Dt=P,zt=k)}const dl={width:0,height:0,left:0,top:0};function fl(){Br(dl,!1)}let fu,pu,mu,gu;function _u(v,y,P,k,z,J,re){ji=!0,on=rn=un._x=un._y=!1,ul(v,y,P,k,z,J,re,!0,!1),v!=null&&(Ne(vl,cc,vu,!1),sr(Au,n,so,oo,ne,j,null));let{left:de,top:ge,width:Pe,height:Le}=It;fu=de,pu=ge,mu=Pe,gu=Le}function vu(v,y,P,k,z,J,re){ji=un._x=un._y=!1,ul(v,y,P,k,z,J,re,!1,!0);let{left:de,top:ge,width:Pe,height:Le}=It,De=Pe>0||Le>0,Ke=fu!=de||pu!=ge||mu!=Pe||gu!=Le;if(De&&Ke&&Br(It),un.setScale&&De&&Ke){let Mt=de,bt=Pe,rt=ge,Xe=Le;if(C.ori==1&&(Mt=ge,bt=Le,rt=de,Xe=Pe),on&&Yi(L,mi(Mt,L),mi(Mt+bt,L)),rn)for(let Ge in b){let kt=b[Ge];Ge!=L&&kt.from==null&&kt.min!=Pt&&Yi(Ge,mi(rt+Xe,Ge),mi(rt,Ge))}fl()}else me.lock&&(me._lock=!me._lock,Ms(y,!0,v!=null));v!=null&&(I(vl,cc),sr(vl,n,Dt,zt,ne,j,null))}function gg(v,y,P,k,z,J,re){if(me._lock)return;Zt(v);let de=ji;if(ji){let ge=!0,Pe=!0,Le=10,De,Ke;C.ori==0?(De=on,Ke=rn):(De=rn,Ke=on),De&&Ke&&(ge=Dt<=Le||Dt>=ne-Le,Pe=zt<=Le||zt>=j-Le),De&&ge&&(Dt=Dt<so?0:ne),Ke&&Pe&&(zt=zt<oo?0:j),Ms(null,!0,!0),ji=!1}Dt=-10,zt=-10,_e.fill(null),Ms(null,!0,!0),de&&(ji=de)}function bu(v,y,P,k,z,J,re){me._lock||(Zt(v),Ue(),fl(),v!=null&&sr(Pu,n,Dt,zt,ne,j,null))}function yu(){S.forEach(d_),le(n.width,n.height,!0)}Bs(Ca,Po,yu);const lo={};lo.mousedown=_u,lo.mousemove=du,lo.mouseup=vu,lo.dblclick=bu,lo.setSeries=(v,y,P,k)=>{let z=$t.match[2];P=z(n,y,P),P!=-1&&pi(P,k,!0,!1)},ue&&(Ne(Au,g,_u),Ne(_l,g,du),Ne(Ru,g,v=>{Zt(v),ir(!1)}),Ne(Cu,g,gg),Ne(Pu,g,bu),_c.add(n),n.syncRect=ir);const Hr=n.hooks=i.hooks||{};function an(v,y,P){rl?er.push([v,y,P]):v in Hr&&Hr[v].forEach(k=>{k.call(null,n,y,P)})}(i.plugins||[]).forEach(v=>{for(let y in v.hooks)Hr[y]=(Hr[y]||[]).concat(v.hooks[y])});const xu=(v,y,P)=>P,$t=jt({key:null,setSeries:!1,filters:{pub:Hu,sub:Hu},scales:[L,M[1]?M[1].scale:null],match:[Vu,Vu,xu],values:[null,null]},me.sync);$t.match.length==2&&$t.match.push(xu),me.sync=$t;const Mu=$t.key,pl=Cp(Mu);function sr(v,y,P,k,z,J,re){$t.filters.pub(v,y,P,k,z,J,re)&&pl.pub(v,y,P,k,z,J,re)}pl.sub(n);function _g(v,y,P,k,z,J,re){$t.filters.sub(v,y,P,k,z,J,re)&&lo[v](null,y,P,k,z,J,re)}n.pub=_g;function vg(){pl.unsub(n),_c.delete(n),pt.clear(),dc(Ca,Po,yu),c.remove(),he?.remove(),an("destroy")}n.destroy=vg;function ml(){an("init",i,e),ze(e||i.data,!1),$[L]?al(L,$[L]):Ue(),Me=It.show&&(It.width>0||It.height>0),H=se=!0,le(i.width,i.height)}return M.forEach(Qo),S.forEach(sl),t?t instanceof HTMLElement?(t.appendChild(c),ml()):t(n,ml):ml(),n}bn.assign=jt;bn.fmtNum=xh;bn.rangeNum=Pa;bn.rangeLog=Xa;bn.rangeAsinh=bh;bn.orient=Ks;bn.pxRatio=St;bn.join=i0;bn.fmtDate=Sh,bn.tzDate=p0;bn.sync=Cp;{bn.addGap=K0,bn.clipGaps=Ka;let i=bn.paths={points:kp};i.linear=Fp,i.stepped=Q0,i.bars=e_,i.spline=n_}const f_="Hand in",p_="To hand in: press Stand up, push the robot, then Hand in within a minute, and change nothing else in between. It saves a file on this device: give it to your teacher.",m_="This robot's electronics are a file of their own: a hand-in of it cannot be run again.",g_="There is no run to hand in: press Stand up, push the robot, then hand in within a minute.",__=".",v_="Certify",b_="(at most 5 % is allowed)",y_="{job} stopped: {why}",x_="{text}",M_="Results as CSV",S_="To join the class",w_="English",E_="upright lab",T_="Skip to the controls",A_="Connecting …",R_="The simulation is starting …",C_="Live",P_="No connection; trying again",L_="The lab does not answer. This page goes on by itself once upright lab runs again.",N_="Recording",D_="This page has stopped",I_="Light or dark",k_="What the buttons, keys and mouse do",U_="Close",F_="The robot in its room. Drag its body to push it; drag the floor to change the view.",O_="{body} leans {pitch} degrees and has rolled {way} centimetres.",z_="{body} has fallen.",B_="twin",H_="nonlinear model",V_="linear model",G_="published model",W_="calibrated model",$_="The robot as MuJoCo simulates it, with contact and friction: it stands for the hardware",q_="The full equations of motion of the model, without contact",X_="The same model, linearised about upright: valid for small angles",j_="The model with the equations as they were published",Y_="The model with the parameters that Calibrate has found",K_="It balances by itself: drag it to push it",Z_="More curves",J_="Fewer curves",Q_="robot: {body}",ev="knock {size} N s",tv="held from the front",nv="held from behind",iv="pulled left",sv="pulled right",ov="push {size} N s",rv="push",av="stood up",lv="best knock {best} N s",cv="The largest single knock, or push by hand of at most half a second, that it has recovered from. A longer push holds the robot and does not count. Nor does one that comes before it has recovered from another.",hv="Push a robot on two wheels, and see what keeps it upright",uv="New here? Take the tour",dv="1000 robots, each a little different, are held, released and knocked in simulation: about half a minute.",fv="Searching for the parameters with which the model predicts the log best.",pv="Searching the log for faults of units, signs, time and sensors.",mv="It begins soon; jobs run one at a time.",gv="{seconds} s so far",_v="about {seconds} s left",vv="{seconds} s so far, longer than expected",bv="300 robots, each a little different, are pushed in simulation. This takes a few seconds.",yv="It fell.",xv="Stand up",Mv="Tilt",Sv="The robot stands up again, tilted by 0.1 rad (6°), and is let go",wv="Pause",Ev="Play",Tv="One step",Av="While paused: goes on by one step of the controller, some thousandths of a second",Rv="Speed",Cv="Back in time",Pv="Time",Lv="It lies; press Stand up first.",Nv="now",Dv="Pushes",Iv="Hold from the front",kv="A force on the front that holds a lean of +0.1 rad for 3 s and is then released (the paper's first push)",Uv="Hold from behind",Fv="A force on the back that holds a lean of −0.12 rad for 3 s and is then released (the paper's second push)",Ov="Knock",zv="A short blow to the body, of the size beside it (K)",Bv="Pull left",Hv="Pull right",Vv="Pull left, Pull right",Gv="A pull at one wheel for 0.3 s, a quarter of the robot's weight: it turns",Wv="Size",$v="Force times time: 0.05 N s is what an apple of 100 g brings at half a metre per second",qv="Arrow keys drive and turn",Xv="pitch",jv="pitch rate",Yv="wheel angle",Kv="wheel rate",Zv="yaw",Jv="yaw rate",Qv="Traces of the last seconds",eb="Seconds shown",tb="Settings, views and files",nb="Controller",ib="Robot",sb="Kit",ob="See",rb="Identify",ab="Keep",lb="Tour",cb="Class",hb="Method",ub="LQG: Kalman filter with dead time",db="LQR with a Kalman filter",fb="LQI: LQG with an integral of the wheel angle",pb="PID cascade",mb="H∞",gb="MPC: predictive, keeps limits",_b="Sliding mode",vb="Robust: one gain for many robots",bb="Gains by hand: u = −K x",yb="No controller",xb="There is no controller, so there is no loop.",Mb="Largest accepted deviations (Bryson's rule): smaller means stricter",Sb="command",wb="Back to the default weights",Eb="This method has no weights to set here.",Tb="The weights of this controller were fixed when it was designed. To change something here, choose Gains by hand. In the live lab (upright lab, with Python) you can set them.",Ab="The new controller drives now: push the robot.",Rb="There is no certificate in this page. The live lab computes one for gains by hand, too: upright lab.",Cb="Each change here designs the controller anew, for the kit as it is then. So a longer dead time that is known does less harm.",Pb="waits for the job in Identify",Lb="What this log does not separate ({n})",Nb="Refused: it is not taken over, since the log contradicts the robot's file.",Db="This run carried {mass} g that the robot's file does not have. Set Payload to 0 under Robot, push and drive for half a minute, then calibrate again.",Ib=", at the kit's own dead time",kb="The margins are for the kit's own dead time, {own} ms. The slider adds {by} ms to it.",Ub="The margins are for the kit's own dead time, {own} ms. The slider takes {by} ms off it.",Fb="The margins are for the kit's own dead time, {own} ms. The slider uses {by} ms of the {bears} ms that the loop bears at both motors.",Ob="The slider adds {by} ms of dead time, more than the {bears} ms that the loop bears at both motors.",zb="Designing …",Bb="A robust design takes some ten seconds, longer on a busy machine. Until then another controller drives.",Hb="Gain K on the left motor",Vb="Gain K",Gb="If only both motors change together",Wb="(not the weakest place)",$b="u = −K x, in {unit}. ψ pitch, θ wheel angle and φ yaw are in rad; a dot marks their rates, in rad/s.",qb="gain factor",Xb="phase",jb="more delay",Yb="The loop bears {delay} ms more delay at its weakest place ({place}); at least {least} ms are needed.",Kb="It bears signals that are {down} % weaker ({low}) or {up} % stronger ({high}); at least 4 % is needed.",Zb="It bears signals that are {down} % weaker ({low}), or as strong as they like.",Jb="The loop bears any delay.",Qb="The margins suffice, but the certificate is red.",ey="The margins suffice, but the certificate is amber.",ty="Already at the motors the margins are thin.",ny="Each sensor counts as the motors do: the smallest margin of all places is being computed …",iy="Each sensor counts as the motors do: the smallest margin of all places waits for the job in Identify.",sy="Each sensor counts as the motors do: the smallest margin of all places is part of the certificate.",oy="Each sensor counts as the motors do: the live lab computes the smallest margin of all places.",ry="Saved; to save again:",ay="Link copied. It opens this page on this computer; for others, put the page on a web host.",ly="lean {size} rad",cy="Link copied. It opens on this computer. For others, start the lab with upright lab --class.",hy="The comparison is ready: it stands in the tab Identify.",uy="Comparison ready:",dy="Save {name}",fy="Open",py="{what}: large or small",my="Fewer",gy="More",_y="sets off by itself",vy="There is no certificate in this page: the tab Python has its command.",by="The margins suffice.",yy="{met} of 5 margins reach the usual targets.",xy="The margins are thin.",My="unlimited",Sy="Certificate",wy="green, fit for the real robot",Ey="amber, with care",Ty="red, not fit for the real robot",Ay="computing …",Ry="{n} of {all} runs …",Cy="none",Py="red, no controller",Ly="This page has no robot '{name}'; it shows {shown}. It has: {all}.",Ny="This page leaves parts of the link out: {parts}.",Dy="This page has no controller '{name}' for this robot; it shows {shown}. It has: {all}.",Iy="The full certificate is ready. It stands in the tab Identify, too.",ky="Full certificate",Uy="Robot",Fy="Open robot.toml",Oy="Parameters",zy="The controller is designed for these parameters.",By="Back to the preset's parameters",Hy="Payload unknown to the controller",Vy="Height of the payload above the axle",Gy="Slope of the floor",Wy="Grip of the wheels, coefficient of friction (twin)",$y="Bodies to compare",qy="Electronics",Xy="ideal: nothing between controller and motors",jy="Noise, rounding and bias of the sensors",Yy="Dead time from sensor to motor",Ky="Battery",Zy="Dead zone of the motors",Jy="Back to the kit's values",Qy="Loop: margins, Bode, Nyquist, poles",ex="What to see",tx="Bode plot of the loop broken at both motors",nx="Nyquist plot",ix="Closed-loop poles",sx="Phase portrait",ox="Voltage",rx="Voltage at the left and right motor; bars mark saturation.",ax="Torque of the left and right motor; bars mark saturation.",lx="Estimate",cx="The controller's estimate of the pitch, and the true pitch.",hx="This controller estimates no state: it reads the true state, or nothing.",ux="Equations",dx="v in volts, or in the unit of the torque. Dry and rolling friction, slope and pushes are added to these.",fx="left",px="right",mx="truth",gx="estimate",_x="saturated",vx="Linearised about upright, ẋ = A x + B u",bx="Open-loop poles",yx="Log to use",xx="this run (the last minute)",Mx="Open a log",Sx="Doctor",wx="Finds faults of the log: units, signs, delays, bias …",Ex="Calibrate",Tx="Estimates the robot's parameters from its raw sensors; the calibrated model is shown as a further trace",Ax="Compare",Rx="A page with numbers and figures of all bodies over the last minute, and of the opened log",Cx="Stop",Px="Comparing …",Lx="Another job is still running; the comparison may take longer.",Nx="Doctor: finds faults of the log. Calibrate: finds the robot's parameters in it; push and drive the robot for half a minute first, it then computes for some ten seconds to two minutes. Compare: a page of numbers and figures of all bodies.",Dx="Log",Ix="The files hold the run since the last change, at most the last minute.",kx="Data, for a spreadsheet or for upright",Ux="Pages: numbers and figures, or the run to be seen again",Fx="Files, for the commands of upright",Ox="To show it: a picture, or a link to this set-up",zx="Log as CSV: what the curves show, at most the last minute, for a spreadsheet or for upright. Picture: the robot as you see it now.",Bx="A report and a replay page need Python: the live lab (upright lab) makes them.",Hx="Log as CSV",Vx="Log as Parquet",Gx="Report",Wx="Replay page",$x="Controller file",qx="Robot file",Xx="Picture",jx="Copy link",Yx="Link copied. It restores this whole set-up.",Kx="It carries no push.",Zx="It repeats the last push.",Jx="Your push by hand is in it as a knock of the same impulse.",Qx="Your push by hand was too long to be in it.",eM="{name} is ready",tM="Recovered from a push of {impulse} N s; largest so far {best} N s",nM="Recovered from a push of {impulse} N s, the largest so far",iM="It recovered, but not from a single push: no record.",sM="It fell after a push of {impulse} N s.",oM="It fell: several pushes, {impulse} N s in all, before it had recovered.",rM="Reading {name}",aM="force {force} N",lM="Board",cM="Name",hM="Largest push [N s]",uM="Effort",dM="Send my set-up to everyone",fM="Your name",pM="Type your name first.",mM="Token",gM="Join",_M="Join the class",vM="Step {n} of {all}",bM="Do",yM="Watch",xM="Think",MM="Prepare",SM="Next",wM="Back to my robot",EM=", without the payload",TM=", on a level floor",AM="Writing the file",RM="Previous",CM=[["Mouse on the robot","drag and hold to push"],["Mouse on the floor","drag to change the view, scroll to zoom"],["One finger","on the robot: push it; beside it: change the view, sideways"],["← → ↑ ↓","turn and drive; a gamepad's left stick does the same"],["F, B","push from the front, from the back, while the key is held"],["K","knock"],["Space","pause and continue"],[".","one step"],[", and /","back and forth in time, while paused"],["S","stand up"],["1, 2, 3 …","open the first, second, third … tab"],["N, P","next and previous step of the tour; Enter sets it up"],["[ ] { } + −","change the view and zoom, while the room has the focus"],["?","this list"]],PM="Python",LM="Linear model as a ghost beside the robot",NM="Payload unknown to the controller: {mass} g, {height} cm above the axle",DM="The controller stays as it was designed: for a level floor and the kit's own dead time.",IM="Copy link",kM="A link to this robot and controller, and to the last push; a short one by hand becomes a knock",UM="Link copied. Whoever opens it sees this robot and this controller.",FM="What follows needs upright, a program for Python 3.11 or newer. Whoever made this page has its folder: open a terminal in it, and type once:",OM="pip install .",zM="Copy",BM="Copied.",HM=[["A log of the twin of this robot, excited so that it can be calibrated from","upright example excited -o run.csv"],["A log of the twin of this robot, tilted, driven and turned so that it can be calibrated from","upright simulate -r {robot} -b twin -c lqg --start pitch=0.1 --drive {speed},start=1,until=4 --turn 1,start=2,until=5 -s 6 -o run.csv"],["Calibrate the robot from that log","upright calibrate run.csv --robot {robot}"],["Design this controller, with its margins, and save it","upright design {controller} -r {robot} -o controller.json"],["Certify this controller","upright certify {controller} -r {robot}"],["Your own robot, from a file, in a page like this","upright lab --export site --robot mine.toml"],["The live lab, with the MuJoCo twin, payloads, other electronics and every parameter","upright lab"]],VM=[{title:"Push it",do:"Press Knock. Or drag the robot with the mouse or a finger, and let go.",watch:"The wheels roll under the body, and its lean ψ comes back to zero: 0.1 rad is 6°. θ is the angle of the wheels. Before the first push it may stand still: the motors do not answer to small voltages. Or it sets off by itself, where the noise of the sensors passes this dead zone. Once it moves it goes on to sway a little, because of both.",ask:"How large a knock can it bear? The slider Size sets it. The robot is the twin, which MuJoCo simulates in place of the hardware; the pale ghosts are simpler models. Where do their curves differ in the second after the knock?",here:{watch:"The wheels roll under the body, and its lean ψ comes back to zero: 0.1 rad is 6°. θ is the angle of the wheels. Before the first push it may stand still: the motors do not answer to small voltages. Or it sets off by itself, where the noise of the sensors passes this dead zone. Once it moves it goes on to sway a little, because of both.",ask:"How large a knock can it bear? The slider Size sets it. The pale ghost beside the robot is a simpler, linear model: where does its curve differ in the second after the knock?"}},{title:"It falls by itself",do:"Press Prepare: nothing controls the robot then. It starts with a lean of 0.02 rad, in slow motion (× 1/10).",watch:"After the first tenth of a second ψ grows like an exponential, because one open-loop pole lies in the right half-plane. Its curve is shown up to 0.3 rad here.",ask:"How long does the lean take from 0.1 to 0.2 rad? Compare with ln 2 divided by the unstable pole (See, Equations). Why is the first doubling, from rest, slower?"},{title:"Linearise",do:"Press Prepare: only the two models start, without a controller, from a small lean. They fall in slow motion (× 1/10).",watch:"The pitch ψ of both models agrees almost down to the floor. The wheel angle θ separates halfway.",ask:"Which terms does the linear model approximate? Look at sin ψ and cos ψ. Why does θ show it before ψ?"},{title:"Regulate",do:"Press Prepare: an LQR balances it now. Tilt it. Then set the accepted pitch under Controller to about 0.04 rad, and tilt it again.",watch:"A smaller accepted pitch makes a larger gain on ψ. After a tilt the body leans less far, but comes back more slowly, and θ rolls further: its sensors do not show how far it was tilted.",ask:"How do the margins change when the accepted pitch gets smaller? If the whole state were known, a larger gain would bring it back more quickly: what is not known here?",here:{do:"Press Prepare: an LQR balances it now. Tilt it. Then choose Gains by hand under Controller. Move ψ pitch → u to about −50 and tilt it again, then to about −9.",watch:"At −50 θ rolls twice as far (8 rad, not 4), and the largest gain factor that it bears falls from 1.29 to 1.12. At −9 the body swings several times. Tilted, it leans further at first, until its sensors show the lean.",ask:"How do the margins change with the gain on ψ? What do its sensors not know after a tilt?"}},{title:"Push the front",do:"Press Prepare: after a second a force on the front holds ψ near 0.1 rad for 3 s, and is then released.",watch:"The robot leans into the force, at first a little further, and rolls backwards. After the release ψ swings beyond zero, to about −0.02 rad, and the wheels return.",ask:"Why does a push on the front hold a forward lean? Think of the sum of moments."},{title:"Push the back",do:"Press Prepare: after a second a force from behind holds ψ near −0.12 rad for 3 s, and is then released.",watch:"The same response, mirrored. Its lean is a fifth larger, and θ at least so much: that differs from run to run. φ, under More curves, hardly moves.",ask:"Is the response exactly the mirror image? What would make the two sides differ?"},{title:"Compare",do:"Press Prepare: twin and models are held in the same way, and released. When they stand again, open Identify and press Compare.",watch:"All three agree. What is left is mostly noise: settling times jump by tenths of a second from run to run. Press Prepare again and compare.",ask:"The push is small: why is the linear model as good as the nonlinear one? Which signal shows the noise most?"},{title:"Break the linear model",do:"Press Prepare: the robot carries 200 g, 30 cm above its axle, that neither the controller nor the linear model includes. Knock it gently, then harder.",watch:"It may begin to sway by itself. After a gentle knock the linear ghost almost comes to rest, and the twin goes on to sway widely. At 0.3 N s the ghost falls, though it bore this knock in the first step. The knock hits at the centre of mass of the loaded robot. That is higher, so it turns the ghost, which has no payload, twice as fast.",ask:"Why does the loaded robot bear this knock from rest, but not always while it sways? How large a payload does it carry at most?",here:{do:"Press Prepare: the robot carries 300 g, 30 cm above its axle, that neither the controller nor the linear model includes. Knock it gently, then harder.",watch:"It may begin to sway by itself. After a gentle knock the linear ghost almost comes to rest, and the robot goes on to sway widely. At 0.3 N s the ghost falls, though it bore this knock in the first step. The knock hits at the centre of mass of the loaded robot. That is higher, so it turns the ghost, which has no payload, twice as fast.",ask:"Why does the loaded robot bear this knock from rest, but not always while it sways? Can gains by hand carry the payload?"}},{title:"Make it robust",do:"Press Prepare: a robust design has one gain for many robots. It takes some ten seconds. The payload stays on. Repeat your pushes.",watch:"The loaded robot sways as widely as before, but rolls less far. It bears no larger knock: robust means that the margins hold for many robots. The light of the certificate says whether the controller is fit for the real robot. For it, 300 robots that differ a little are pushed in simulation, without the payload.",ask:"What is the largest knock from rest that it bears, and that the regulator of the step before bears? What else did robustness cost? Compare effort and travel in a report (Keep)."}],GM="This robot cannot be simulated. The one before it stands here again.",WM="That was too much at once: some of it was left out. Wait a moment.",$M="The simulation stopped and was started again. All robots stand upright.",qM="Your last change stopped the simulation for all. The usual robot stands here instead.",Tr={handIn:f_,handInNote:p_,noReplay:m_,noRun:g_,decimal:__,certify:v_,allowed:b_,jobStopped:y_,original:x_,results:M_,invite:S_,language:w_,title:E_,skip:T_,connecting:A_,starting:R_,connected:C_,lost:P_,gone:L_,replaying:N_,refused:D_,theme:I_,help:k_,close:U_,scene:F_,sceneNow:O_,fellNow:z_,twin:B_,nonlinear:H_,linear:V_,published:G_,calibrated:W_,twinNote:$_,nonlinearNote:q_,linearNote:X_,publishedNote:j_,calibratedNote:Y_,hint:K_,moreCurves:Z_,fewerCurves:J_,robotIs:Q_,mark_impulse:ev,mark_front:tv,mark_back:nv,mark_pull_left:iv,mark_pull_right:sv,mark_hand:ov,mark_held:rv,mark_stood:av,best:lv,bestTip:cv,what:hv,newHere:uv,doing_certify:dv,doing_calibrate:fv,doing_doctor:pv,oneAtATime:mv,soFar:gv,stillTakes:_v,overdue:vv,lightNote:bv,fallen:yv,standUp:xv,tilt:Mv,tiltTip:Sv,pause:wv,play:Ev,step:Tv,stepTip:Av,speed:Rv,back:Cv,timeLine:Pv,lies:Lv,now:Nv,pushes:Dv,front:Iv,frontTip:kv,backPush:Uv,backTip:Fv,impulse:Ov,impulseTip:zv,pullLeft:Bv,pullRight:Hv,pullBoth:Vv,pullTip:Gv,size:Wv,sizeTip:$v,drive:qv,pitch:Xv,pitch_rate:jv,wheel:Yv,wheel_rate:Kv,yaw:Zv,yaw_rate:Jv,charts:Qv,window:eb,tabs:tb,tabController:nb,tabRobot:ib,tabKit:sb,tabSee:ob,tabIdentify:rb,tabKeep:ab,tabTour:lb,tabClass:cb,family:hb,lqg:ub,lqr:db,"lqr-complementary":"LQR with a complementary filter","lqr-state":"LQR on the true state (simulation only)",lqi:fb,pid:pb,hinf:mb,mpc:gb,sliding:_b,robust:vb,gains:bb,off:yb,noLoop:xb,weights:Mb,command:Sb,ownWeights:wb,noWeights:Eb,fixedWeights:Tb,designed:Ab,noCertificateByHand:Rb,redesigned:Cb,queued:Pb,notSeparated:Lb,refusedMeans:Nb,calibratedLaden:Db,butDelay:Ib,delayMore:kb,delayLess:Ub,delayUsed:Fb,delayLost:Ob,designing:zb,robustTakes:Bb,gain:Hb,gainBoth:Vb,margins:Gb,notWeakest:Wb,gainNote:$b,gainMargin:qb,phaseMargin:Xb,delayMargin:jb,leastDelay:Yb,leastGain:Kb,leastGainLow:Zb,anyDelay:Jb,enoughRed:Qb,enoughAmber:ey,thinMotors:ty,placesPending:ny,placesQueued:iy,placesCertificate:sy,placesPython:oy,saved:ry,lookHere:ay,mark_tilt:ly,linkHere:cy,comparedThere:hy,compared:uy,saveAs:dy,open:fy,large:py,fewer:my,more:gy,mark_self:_y,noCertificateHere:vy,enough:by,targetsMet:yy,thin:xy,unlimited:My,certificate:Sy,green:wy,amber:Ey,red:Ty,none:Ay,tried:Ry,noCertificate:Cy,noneRed:Py,noSuchRobot:Ly,leftOut:Ny,noSuchController:Dy,certified:Iy,fullCertificate:ky,preset:Uy,openRobot:Fy,numbers:Oy,numbersNote:zy,ownNumbers:By,payload:Hy,payloadHeight:Vy,slope:Gy,grip:Wy,bodies:$y,kit:qy,ideal:Xy,noise:jy,delay:Yy,voltage:Ky,deadZone:Zy,ownKit:Jy,loop:Qy,viewLabel:ex,bode:tx,nyquist:nx,poles:ix,portrait:sx,voltages:ox,voltagesNote:rx,torquesNote:ax,estimate:lx,estimateNote:cx,noEstimate:hx,equations:ux,equationsNote:dx,leftMotor:fx,rightMotor:px,truth:mx,opinion:gx,saturated:_x,linearised:vx,openPoles:bx,source:yx,thisRun:xx,openLog:Mx,doctor:Sx,doctorTip:wx,calibrate:Ex,calibrateTip:Tx,compare:Ax,compareTip:Rx,stop:Cx,comparing:Px,compareWaits:Lx,calibrateNote:Nx,log:Dx,keepNote:Ix,keepData:kx,keepPages:Ux,keepFiles:Fx,keepShow:Ox,csvNote:zx,keepLive:Bx,csv:Hx,parquet:Vx,report:Gx,replay:Wx,controllerFile:$x,robotFile:qx,picture:Xx,link:jx,linkCopied:Yx,noPush:Kx,namedPush:Zx,knockPush:Jx,heldPush:Qx,made:eM,recovered:tM,recoveredMost:nM,recoveredSeveral:iM,lostPush:sM,lostPushes:oM,uploaded:rM,newtons:aM,board:lM,name:cM,bestPush:hM,effort:uM,broadcast:dM,yourName:fM,nameMissing:pM,token:mM,enter:gM,joinTitle:_M,tourStep:vM,tourDo:bM,tourWatch:yM,tourAsk:xM,tourSet:MM,next:SM,tourBack:wM,butPayload:EM,butSlope:TM,writing:AM,previous:RM,keys:CM,tabPython:PM,ghost:LM,carries:NM,stays:DM,lookAtThis:IM,lookTip:kM,lookCopied:UM,pythonNote:FM,install:OM,copy:zM,copied:BM,python:HM,tour:VM,setBack:GM,tooMany:WM,restarted:$M,ended:qM},XM="Entregar",jM="Para entregar: presione Poner de pie, empuje el robot y presione Entregar antes de un minuto, sin cambiar nada más. Guarda un archivo en este equipo: déselo a su docente.",YM="La electrónica de este robot es un archivo propio: su entrega no se puede repetir.",KM="No hay nada que entregar: presione Poner de pie, empuje el robot y entregue antes de un minuto.",ZM=",",JM="Certificar",QM="(se permite un 5 % como máximo)",eS="{job} se detuvo: {why}",tS="Mensaje original: {text}",nS="Resultados en CSV",iS="Para unirse a la clase",sS="Español",oS="upright lab",rS="Ir a los controles",aS="Conectando …",lS="La simulación está arrancando …",cS="En vivo",hS="Sin conexión; se intenta de nuevo",uS="El laboratorio no responde. Esta página sigue por sí sola cuando upright lab funcione otra vez.",dS="Grabación",fS="Esta página se ha detenido",pS="Claro u oscuro",mS="Qué hacen los botones, las teclas y el mouse",gS="Cerrar",_S="El robot en su sala. Arrastre su cuerpo para empujarlo; arrastre el suelo para cambiar la vista.",vS="{body} se inclina {pitch} grados y ha rodado {way} centímetros.",bS="{body} se ha caído.",yS="gemelo",xS="modelo no lineal",MS="modelo lineal",SS="modelo publicado",wS="modelo calibrado",ES="El robot como lo simula MuJoCo, con contacto y fricción: hace las veces del robot real",TS="Las ecuaciones de movimiento completas del modelo, sin contacto",AS="El mismo modelo, linealizado en vertical: válido para ángulos pequeños",RS="El modelo con las ecuaciones tal como se publicaron",CS="El modelo con los parámetros que encontró Calibrar",PS="Se equilibra solo: arrástrelo para empujarlo",LS="Más curvas",NS="Menos curvas",DS="robot: {body}",IS="golpe {size} N s",kS="sostenido por delante",US="sostenido por detrás",FS="tirón izquierdo",OS="tirón derecho",zS="empujón {size} N s",BS="empujón",HS="de pie",VS="mejor golpe {best} N s",GS="El mayor golpe solo, o empujón a mano de medio segundo como máximo, del que se recuperó. Un empujón más largo sostiene el robot y no cuenta. Tampoco uno dado antes de que se recupere de otro.",WS="Empuje un robot de dos ruedas y vea qué lo mantiene en pie",$S="¿Primera vez? Haga el recorrido",qS="1000 robots, cada uno algo distinto, se sostienen, se sueltan y reciben golpes en simulación: cerca de medio minuto.",XS="Se buscan los parámetros con los que el modelo predice mejor el registro.",jS="Se buscan fallos de unidades, signos, tiempo y sensores en el registro.",YS="Empieza pronto; los trabajos se hacen uno tras otro.",KS="{seconds} s hasta ahora",ZS="faltan unos {seconds} s",JS="{seconds} s hasta ahora, más de lo previsto",QS="300 robots, cada uno algo distinto, reciben empujones en simulación. Tarda unos segundos.",ew="Se cayó.",tw="Poner de pie",nw="Inclinar",iw="El robot se pone de pie otra vez, inclinado 0,1 rad (6°), y se suelta",sw="Pausa",ow="Continuar",rw="Un paso",aw="En pausa: avanza un paso del controlador, unas milésimas de segundo",lw="Velocidad",cw="Atrás en el tiempo",hw="Tiempo",uw="Está caído; presione antes Poner de pie.",dw="ahora",fw="Empujones",pw="Sostener por delante",mw="Una fuerza por delante que mantiene +0,1 rad durante 3 s y luego cesa (el primer empujón del artículo)",gw="Sostener por detrás",_w="Una fuerza por detrás que mantiene −0,12 rad durante 3 s y luego cesa (el segundo empujón del artículo)",vw="Dar un golpe",bw="Un golpe breve al cuerpo, del tamaño que está al lado (K)",yw="Tirón izq.",xw="Tirón der.",Mw="Tirón izq., Tirón der.",Sw="Un tirón de una rueda durante 0,3 s, de un cuarto del peso del robot: gira",ww="Tamaño",Ew="Fuerza por tiempo: 0,05 N s es lo que trae una manzana de 100 g a medio metro por segundo",Tw="Las flechas conducen y giran",Aw="inclinación",Rw="velocidad de inclinación",Cw="ángulo de ruedas",Pw="velocidad de ruedas",Lw="rumbo",Nw="velocidad de giro",Dw="Trazas de los últimos segundos",Iw="Segundos mostrados",kw="Ajustes, vistas y archivos",Uw="Controlador",Fw="Robot",Ow="Electrónica",zw="Ver",Bw="Identificar",Hw="Guardar",Vw="Recorrido",Gw="Clase",Ww="Método",$w="LQG: filtro de Kalman con retardo",qw="LQR con filtro de Kalman",Xw="LQI: LQG con integral del ángulo de ruedas",jw="PID en cascada",Yw="H∞",Kw="MPC: predictivo, respeta límites",Zw="Modo deslizante",Jw="Robusto: una ganancia para muchos robots",Qw="Ganancias a mano: u = −K x",e1="Sin controlador",t1="No hay controlador, así que no hay lazo.",n1="Mayores desviaciones aceptadas (regla de Bryson): menor es más estricto",i1="mando",s1="Volver a los pesos predeterminados",o1="Este método no tiene pesos que ajustar aquí.",r1="Los pesos de este controlador quedaron fijados al diseñarlo. Para cambiar algo aquí, elija Ganancias a mano. En el laboratorio en vivo (upright lab, con Python) también se pueden cambiar.",a1="El nuevo controlador ya actúa: empuje el robot.",l1="En esta página no hay certificado. El laboratorio en vivo lo calcula también para ganancias a mano: upright lab.",c1="Cada cambio aquí diseña de nuevo el controlador, para la electrónica tal como queda. Por eso un retardo mayor, si se conoce, daña menos.",h1="espera al trabajo de Identificar",u1="Lo que este registro no separa ({n})",d1="Rechazado: no se adopta, pues el registro contradice el archivo del robot.",f1="En este ensayo el robot llevaba {mass} g que su archivo no tiene. Ponga la carga en 0 en Robot, empuje y conduzca medio minuto, y calibre de nuevo.",p1=", con el retardo propio de la electrónica",m1="Los márgenes son para el retardo propio de la electrónica, {own} ms. El deslizador le suma {by} ms.",g1="Los márgenes son para el retardo propio de la electrónica, {own} ms. El deslizador le resta {by} ms.",_1="Los márgenes son para el retardo propio de la electrónica, {own} ms. El deslizador gasta {by} ms de los {bears} ms que el lazo soporta en ambos motores.",v1="El deslizador suma {by} ms de retardo, más que los {bears} ms que el lazo soporta en ambos motores.",b1="Diseñando …",y1="Un diseño robusto tarda unos diez segundos, más en una máquina ocupada. Hasta entonces actúa otro controlador.",x1="Ganancia K del motor izquierdo",M1="Ganancia K",S1="Si solo cambian ambos motores a la vez",w1="(no es el punto más débil)",E1="u = −K x, en {unit}. ψ inclinación, θ ángulo de rueda y φ rumbo van en rad; el punto marca su velocidad, en rad/s.",T1="factor de ganancia",A1="fase",R1="más retardo",C1="En su punto más débil ({place}) el lazo soporta {delay} ms más de retardo; se piden al menos {least} ms.",P1="Soporta señales un {down} % más débiles ({low}) o un {up} % más fuertes ({high}); se pide al menos un 4 %.",L1="Soporta señales un {down} % más débiles ({low}), o tan fuertes como se quiera.",N1="El lazo soporta cualquier retardo.",D1="Los márgenes bastan, pero el certificado es rojo.",I1="Los márgenes bastan, pero el certificado es ámbar.",k1="Ya en los motores los márgenes son escasos.",U1="Cada sensor cuenta igual que los motores: se está calculando el margen más pequeño de todos los puntos …",F1="Cada sensor cuenta igual que los motores: el margen más pequeño de todos los puntos espera al trabajo de Identificar.",O1="Cada sensor cuenta igual que los motores: el margen más pequeño de todos los puntos es parte del certificado.",z1="Cada sensor cuenta igual que los motores: el laboratorio en vivo calcula el margen más pequeño de todos los puntos.",B1="Guardado; para guardarlo otra vez:",H1="Enlace copiado. Abre esta página en este computador; para otras personas, póngala en un servidor web.",V1="inclinación {size} rad",G1="Enlace copiado. Se abre en esta computadora. Para otras, inicie el laboratorio con upright lab --class.",W1="La comparación está lista: está en la pestaña Identificar.",$1="Comparación lista:",q1="Guardar {name}",X1="Abrir",j1="{what}: grande o pequeña",Y1="Menos",K1="Más",Z1="se mueve solo",J1="En esta página no hay certificado: la pestaña Python tiene su comando.",Q1="Los márgenes bastan.",eE="{met} de 5 márgenes alcanzan los objetivos habituales.",tE="Los márgenes son escasos.",nE="sin límite",iE="Certificado",sE="verde, apto para el robot real",oE="ámbar, con cuidado",rE="rojo, no apto para el robot real",aE="calculando …",lE="{n} de {all} pruebas …",cE="ninguno",hE="rojo, sin controlador",uE="Esta página no tiene el robot '{name}'; muestra {shown}. Tiene: {all}.",dE="Esta página deja fuera partes del enlace: {parts}.",fE="Esta página no tiene el controlador '{name}' para este robot; muestra {shown}. Tiene: {all}.",pE="El certificado completo está listo. También está en la pestaña Identificar.",mE="Certificado completo",gE="Robot",_E="Abrir robot.toml",vE="Parámetros",bE="El controlador se diseña para estos parámetros.",yE="Volver a los parámetros del preajuste",xE="Carga que el controlador desconoce",ME="Altura de la carga sobre el eje",SE="Pendiente del suelo",wE="Agarre de las ruedas, coeficiente de fricción (gemelo)",EE="Cuerpos",TE="Electrónica",AE="ideal: nada entre controlador y motores",RE="Ruido, redondeo y sesgo de los sensores",CE="Retardo del sensor al motor",PE="Batería",LE="Zona muerta de los motores",NE="Volver a los valores de la electrónica",DE="Lazo: márgenes, Bode, Nyquist, polos",IE="Qué se ve",kE="Diagrama de Bode del lazo abierto en ambos motores",UE="Diagrama de Nyquist",FE="Polos en lazo cerrado",OE="Plano de fase",zE="Tensión",BE="Tensión en el motor izquierdo y en el derecho; las barras marcan saturación.",HE="Par del motor izquierdo y del derecho; las barras marcan saturación.",VE="Estimación",GE="La inclinación estimada por el controlador y la verdadera.",WE="Este controlador no estima el estado: lee el verdadero, o nada.",$E="Ecuaciones",qE="v en voltios, o en la unidad del par. A esto se suman fricción seca y de rodadura, pendiente y empujones.",XE="izquierdo",jE="derecho",YE="verdad",KE="estimación",ZE="saturado",JE="Linealizado en vertical, ẋ = A x + B u",QE="Polos en lazo abierto",eT="Registro que se usa",tT="este ensayo (el último minuto)",nT="Abrir un registro",iT="Doctor",sT="Busca fallos del registro: unidades, signos, retardos, sesgo …",oT="Calibrar",rT="Estima los parámetros del robot a partir de sus sensores; el modelo calibrado se muestra como otra traza",aT="Comparar",lT="Una página con números y figuras de todos los cuerpos en el último minuto, y del registro abierto",cT="Parar",hT="Comparando …",uT="Otro trabajo sigue en marcha; la comparación puede tardar más.",dT="Doctor: busca fallos del registro. Calibrar: halla en él los parámetros del robot; antes empuje y conduzca el robot medio minuto, después calcula de diez segundos a dos minutos. Comparar: una página con números y figuras de todos los cuerpos.",fT="Registro",pT="Los archivos contienen el ensayo desde el último cambio, como mucho el último minuto.",mT="Datos, para una hoja de cálculo o para upright",gT="Páginas: números y figuras, o el ensayo para verlo otra vez",_T="Archivos, para las órdenes de upright",vT="Para mostrarlo: una imagen, o un enlace a esta configuración",bT="Registro CSV: lo que muestran las curvas, como máximo el último minuto, para una hoja de cálculo o para upright. Imagen: el robot como se ve ahora.",yT="El informe y la página de repetición requieren Python: los hace el laboratorio en vivo (upright lab).",xT="Registro CSV",MT="Registro Parquet",ST="Informe",wT="Página con la grabación",ET="Archivo del controlador",TT="Archivo del robot",AT="Imagen",RT="Copiar enlace",CT="Enlace copiado. Restaura toda esta configuración.",PT="No lleva ningún empujón.",LT="Repite el último empujón.",NT="Su empujón a mano va en él como un golpe del mismo impulso.",DT="Su empujón a mano fue demasiado largo para ir en él.",IT="{name} está listo",kT="Se recuperó de un empujón de {impulse} N s; el mayor hasta ahora {best} N s",UT="Se recuperó de un empujón de {impulse} N s, el mayor",FT="Se recuperó, pero no de un solo empujón: no es récord.",OT="Se cayó tras un empujón de {impulse} N s.",zT="Se cayó: varios empujones, {impulse} N s en total, antes de recuperarse.",BT="Se está leyendo {name}",HT="fuerza {force} N",VT="Clasificación",GT="Nombre",WT="Mayor empujón [N s]",$T="Esfuerzo",qT="Enviar mi configuración a todos",XT="Su nombre",jT="Escriba primero su nombre.",YT="Clave",KT="Entrar",ZT="Unirse a la clase",JT="Paso {n} de {all}",QT="Haga",eA="Observe",tA="Piense",nA="Preparar",iA="Siguiente",sA="Volver a mi robot",oA=", sin la carga",rA=", en suelo horizontal",aA="Escribiendo el archivo",lA="Anterior",cA=[["Mouse sobre el robot","arrastrar y mantener para empujar"],["Mouse sobre el suelo","arrastrar para cambiar la vista, rueda para acercarse"],["Un dedo","sobre el robot: empujarlo; al lado: cambiar la vista, de lado"],["← → ↑ ↓","girar y conducir; la palanca izquierda de un mando hace lo mismo"],["F, B","empujar por delante, por detrás, mientras se mantenga la tecla"],["K","golpe"],["Espacio","pausa y continuar"],[".","un paso"],[", y /","atrás y adelante en el tiempo, en pausa"],["S","poner de pie"],["1, 2, 3 …","abrir la primera, segunda, tercera … pestaña"],["N, P","paso siguiente y anterior del recorrido; Intro lo prepara"],["[ ] { } + −","cambiar la vista y acercarse, con el foco en la sala"],["?","esta lista"]],hA="Python",uA="Modelo lineal como fantasma junto al robot",dA="Carga que el controlador desconoce: {mass} g, a {height} cm sobre el eje",fA="El controlador queda como se diseñó: para un suelo horizontal y el retardo propio de la electrónica.",pA="Copiar enlace",mA="Un enlace a este robot y este controlador, y al último empujón; uno breve a mano pasa a ser un golpe",gA="Enlace copiado. Quien lo abra verá este robot y este controlador.",_A="Lo siguiente necesita upright, un programa para Python 3.11 o más nuevo. Quien hizo esta página tiene su carpeta: abra en ella una terminal y escriba una vez:",vA="pip install .",bA="Copiar",yA="Copiado.",xA=[["Un registro del gemelo de este robot, excitado para poder calibrar con él","upright example excited -o run.csv"],["Un registro del gemelo de este robot, inclinado, conducido y girado para poder calibrar con él","upright simulate -r {robot} -b twin -c lqg --start pitch=0.1 --drive {speed},start=1,until=4 --turn 1,start=2,until=5 -s 6 -o run.csv"],["Calibrar el robot a partir de ese registro","upright calibrate run.csv --robot {robot}"],["Diseñar este controlador, con sus márgenes, y guardarlo","upright design {controller} -r {robot} -o controller.json"],["Certificar este controlador","upright certify {controller} -r {robot}"],["Su propio robot, de un archivo, en una página como esta","upright lab --export site --robot mine.toml"],["El laboratorio en vivo, con el gemelo MuJoCo, cargas, otra electrónica y todos los parámetros","upright lab"]],MA=[{title:"Empújelo",do:"Presione Dar un golpe. O arrastre el robot con el mouse o con un dedo, y suéltelo.",watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero: 0,1 rad son 6°. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. O se mueve solo, donde el ruido de los sensores supera esa zona muerta. Una vez movido sigue oscilando un poco, por ambas causas.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El robot es el gemelo, que MuJoCo simula en lugar del robot real; los fantasmas pálidos son modelos más simples. ¿En qué se diferencian sus curvas en el segundo tras el golpe?",here:{watch:"Las ruedas avanzan bajo el cuerpo, y su inclinación ψ vuelve a cero: 0,1 rad son 6°. θ es el ángulo de las ruedas. Antes del primer empujón puede quedar quieto: los motores no responden a voltajes pequeños. O se mueve solo, donde el ruido de los sensores supera esa zona muerta. Una vez movido sigue oscilando un poco, por ambas causas.",ask:"¿Qué golpe aguanta como máximo? El deslizador Tamaño lo fija. El fantasma pálido junto al robot es un modelo más simple, lineal: ¿en qué se diferencia su curva en el segundo tras el golpe?"}},{title:"Se cae solo",do:"Presione Preparar: entonces nada controla el robot. Empieza con una inclinación de 0,02 rad, en cámara lenta (× 1/10).",watch:"Tras la primera décima de segundo ψ crece como una exponencial, porque un polo en lazo abierto está en el semiplano derecho. Su curva se muestra aquí hasta 0,3 rad.",ask:"¿Cuánto tarda la inclinación de 0,1 a 0,2 rad? Compare con ln 2 dividido entre el polo inestable (Ver, Ecuaciones). ¿Por qué tarda más la primera duplicación, desde el reposo?"},{title:"Linealizar",do:"Presione Preparar: solo arrancan los dos modelos, sin controlador, desde una inclinación pequeña. Caen en cámara lenta (× 1/10).",watch:"La inclinación ψ de ambos modelos coincide casi hasta el suelo. El ángulo de rueda θ se separa a mitad de camino.",ask:"¿Qué términos aproxima el modelo lineal? Mire sen ψ y cos ψ. ¿Por qué θ lo muestra antes que ψ?"},{title:"Regular",do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo. Luego ponga la inclinación aceptada en Controlador en unos 0,04 rad, e inclínelo otra vez.",watch:"Una inclinación aceptada menor da una ganancia mayor en ψ. Al inclinarlo, el cuerpo se inclina menos, pero regresa más despacio, y θ rueda más lejos: sus sensores no muestran cuánto se inclinó.",ask:"¿Cómo cambian los márgenes con una inclinación aceptada menor? Si se conociera todo el estado, una ganancia mayor lo haría regresar más rápido: ¿qué no se conoce aquí?",here:{do:"Presione Preparar: ahora un LQR lo equilibra. Inclínelo. Luego elija Ganancias a mano en Controlador. Lleve ψ inclinación → u a unos −50 e inclínelo otra vez; luego a unos −9.",watch:"Con −50 θ rueda el doble (8 rad, no 4), y el mayor factor de ganancia que soporta baja de 1,29 a 1,12. Con −9 el cuerpo oscila varias veces. Al inclinarlo se inclina más al principio, hasta que sus sensores lo muestran.",ask:"¿Cómo cambian los márgenes con la ganancia en ψ? ¿Qué no saben sus sensores después de inclinarlo?"}},{title:"Empujar por delante",do:"Presione Preparar: tras un segundo una fuerza por delante mantiene ψ cerca de 0,1 rad durante 3 s y luego cesa.",watch:"El robot se inclina contra la fuerza, al principio un poco más, y rueda hacia atrás. Al soltarlo ψ pasa de cero hasta unos −0,02 rad, y las ruedas regresan.",ask:"¿Por qué un empujón por delante mantiene una inclinación hacia delante? Piense en la suma de momentos."},{title:"Empujar por detrás",do:"Presione Preparar: tras un segundo una fuerza por detrás mantiene ψ cerca de −0,12 rad durante 3 s y luego cesa.",watch:"La misma respuesta, reflejada. La inclinación es un quinto mayor, y θ al menos otro tanto: cambia de un ensayo a otro. φ, en Más curvas, apenas se mueve.",ask:"¿Es la respuesta exactamente la imagen reflejada? ¿Qué haría diferentes los dos lados?"},{title:"Comparar",do:"Presione Preparar: el gemelo y los modelos se sostienen del mismo modo y se sueltan. Cuando estén de pie otra vez, abra Identificar y presione Comparar.",watch:"Los tres coinciden. Lo que queda es sobre todo ruido: los tiempos de establecimiento saltan décimas de segundo de una prueba a otra. Presione Preparar otra vez y compare.",ask:"El empujón es pequeño: ¿por qué el modelo lineal es tan bueno como el no lineal? ¿Qué señal muestra más el ruido?"},{title:"Romper el modelo lineal",do:"Presione Preparar: el robot lleva 200 g, a 30 cm sobre el eje, que ni el controlador ni el modelo lineal incluyen. Dele un golpe suave, luego uno más fuerte.",watch:"Puede empezar a oscilar solo. Tras un golpe suave el fantasma lineal casi vuelve al reposo, y el gemelo sigue oscilando mucho. Con 0,3 N s cae el fantasma, aunque aguantó ese golpe en el primer paso. El golpe da en el centro de masa del robot cargado. Este está más alto, y por eso hace girar al fantasma, que no lleva carga, al doble de velocidad.",ask:"¿Por qué el robot cargado aguanta este golpe desde el reposo, pero no siempre mientras oscila? ¿Qué carga lleva como máximo?",here:{do:"Presione Preparar: el robot lleva 300 g, a 30 cm sobre el eje, que ni el controlador ni el modelo lineal incluyen. Dele un golpe suave, luego uno más fuerte.",watch:"Puede empezar a oscilar solo. Tras un golpe suave el fantasma lineal casi vuelve al reposo, y el robot sigue oscilando mucho. Con 0,3 N s cae el fantasma, aunque aguantó ese golpe en el primer paso. El golpe da en el centro de masa del robot cargado. Este está más alto, y por eso hace girar al fantasma, que no lleva carga, al doble de velocidad.",ask:"¿Por qué el robot cargado aguanta este golpe desde el reposo, pero no siempre mientras oscila? ¿Puede llevar la carga con ganancias a mano?"}},{title:"Hacerlo robusto",do:"Presione Preparar: un diseño robusto tiene una ganancia para muchos robots. Tarda unos diez segundos. La carga sigue puesta. Repita sus empujones.",watch:"El robot cargado oscila tanto como antes, pero rueda menos. No aguanta un golpe mayor: robusto significa que los márgenes valen para muchos robots. La luz del certificado dice si el controlador es apto para el robot real. Para ella, 300 robots algo distintos reciben empujones en simulación, sin la carga.",ask:"¿Cuál es el mayor golpe que aguanta desde el reposo, y cuál aguanta el regulador del paso anterior? ¿Qué más costó la robustez? Compare esfuerzo y recorrido en un informe (Guardar)."}],SA="Este robot no se puede simular. El anterior está de nuevo aquí.",wA="Fue demasiado a la vez: una parte se omitió. Espere un momento.",EA="La simulación se detuvo y comenzó de nuevo. Todos los robots están de pie.",TA="Su último cambio detuvo la simulación para todos. Aquí está el robot habitual en su lugar.",AA={handIn:XM,handInNote:jM,noReplay:YM,noRun:KM,decimal:ZM,certify:JM,allowed:QM,jobStopped:eS,original:tS,results:nS,invite:iS,language:sS,title:oS,skip:rS,connecting:aS,starting:lS,connected:cS,lost:hS,gone:uS,replaying:dS,refused:fS,theme:pS,help:mS,close:gS,scene:_S,sceneNow:vS,fellNow:bS,twin:yS,nonlinear:xS,linear:MS,published:SS,calibrated:wS,twinNote:ES,nonlinearNote:TS,linearNote:AS,publishedNote:RS,calibratedNote:CS,hint:PS,moreCurves:LS,fewerCurves:NS,robotIs:DS,mark_impulse:IS,mark_front:kS,mark_back:US,mark_pull_left:FS,mark_pull_right:OS,mark_hand:zS,mark_held:BS,mark_stood:HS,best:VS,bestTip:GS,what:WS,newHere:$S,doing_certify:qS,doing_calibrate:XS,doing_doctor:jS,oneAtATime:YS,soFar:KS,stillTakes:ZS,overdue:JS,lightNote:QS,fallen:ew,standUp:tw,tilt:nw,tiltTip:iw,pause:sw,play:ow,step:rw,stepTip:aw,speed:lw,back:cw,timeLine:hw,lies:uw,now:dw,pushes:fw,front:pw,frontTip:mw,backPush:gw,backTip:_w,impulse:vw,impulseTip:bw,pullLeft:yw,pullRight:xw,pullBoth:Mw,pullTip:Sw,size:ww,sizeTip:Ew,drive:Tw,pitch:Aw,pitch_rate:Rw,wheel:Cw,wheel_rate:Pw,yaw:Lw,yaw_rate:Nw,charts:Dw,window:Iw,tabs:kw,tabController:Uw,tabRobot:Fw,tabKit:Ow,tabSee:zw,tabIdentify:Bw,tabKeep:Hw,tabTour:Vw,tabClass:Gw,family:Ww,lqg:$w,lqr:qw,"lqr-complementary":"LQR con filtro complementario","lqr-state":"LQR con el estado verdadero (solo simulado)",lqi:Xw,pid:jw,hinf:Yw,mpc:Kw,sliding:Zw,robust:Jw,gains:Qw,off:e1,noLoop:t1,weights:n1,command:i1,ownWeights:s1,noWeights:o1,fixedWeights:r1,designed:a1,noCertificateByHand:l1,redesigned:c1,queued:h1,notSeparated:u1,refusedMeans:d1,calibratedLaden:f1,butDelay:p1,delayMore:m1,delayLess:g1,delayUsed:_1,delayLost:v1,designing:b1,robustTakes:y1,gain:x1,gainBoth:M1,margins:S1,notWeakest:w1,gainNote:E1,gainMargin:T1,phaseMargin:A1,delayMargin:R1,leastDelay:C1,leastGain:P1,leastGainLow:L1,anyDelay:N1,enoughRed:D1,enoughAmber:I1,thinMotors:k1,placesPending:U1,placesQueued:F1,placesCertificate:O1,placesPython:z1,saved:B1,lookHere:H1,mark_tilt:V1,linkHere:G1,comparedThere:W1,compared:$1,saveAs:q1,open:X1,large:j1,fewer:Y1,more:K1,mark_self:Z1,noCertificateHere:J1,enough:Q1,targetsMet:eE,thin:tE,unlimited:nE,certificate:iE,green:sE,amber:oE,red:rE,none:aE,tried:lE,noCertificate:cE,noneRed:hE,noSuchRobot:uE,leftOut:dE,noSuchController:fE,certified:pE,fullCertificate:mE,preset:gE,openRobot:_E,numbers:vE,numbersNote:bE,ownNumbers:yE,payload:xE,payloadHeight:ME,slope:SE,grip:wE,bodies:EE,kit:TE,ideal:AE,noise:RE,delay:CE,voltage:PE,deadZone:LE,ownKit:NE,loop:DE,viewLabel:IE,bode:kE,nyquist:UE,poles:FE,portrait:OE,voltages:zE,voltagesNote:BE,torquesNote:HE,estimate:VE,estimateNote:GE,noEstimate:WE,equations:$E,equationsNote:qE,leftMotor:XE,rightMotor:jE,truth:YE,opinion:KE,saturated:ZE,linearised:JE,openPoles:QE,source:eT,thisRun:tT,openLog:nT,doctor:iT,doctorTip:sT,calibrate:oT,calibrateTip:rT,compare:aT,compareTip:lT,stop:cT,comparing:hT,compareWaits:uT,calibrateNote:dT,log:fT,keepNote:pT,keepData:mT,keepPages:gT,keepFiles:_T,keepShow:vT,csvNote:bT,keepLive:yT,csv:xT,parquet:MT,report:ST,replay:wT,controllerFile:ET,robotFile:TT,picture:AT,link:RT,linkCopied:CT,noPush:PT,namedPush:LT,knockPush:NT,heldPush:DT,made:IT,recovered:kT,recoveredMost:UT,recoveredSeveral:FT,lostPush:OT,lostPushes:zT,uploaded:BT,newtons:HT,board:VT,name:GT,bestPush:WT,effort:$T,broadcast:qT,yourName:XT,nameMissing:jT,token:YT,enter:KT,joinTitle:ZT,tourStep:JT,tourDo:QT,tourWatch:eA,tourAsk:tA,tourSet:nA,next:iA,tourBack:sA,butPayload:oA,butSlope:rA,writing:aA,previous:lA,keys:cA,tabPython:hA,ghost:uA,carries:dA,stays:fA,lookAtThis:pA,lookTip:mA,lookCopied:gA,pythonNote:_A,install:vA,copy:bA,copied:yA,python:xA,tour:MA,setBack:SA,tooMany:wA,restarted:EA,ended:TA},RA=JSON.parse(`[["there is no run to hand in; expected one of at most {0} s, with no change since Stand up; try: press Stand up, push the robot, then hand in","no hay un ensayo que entregar de {0} s como máximo y sin cambios desde Poner de pie; pruebe: pulse Poner de pie, empuje el robot y entregue"],["no robot is called '{0}'; expected one of {1}","no hay un robot '{0}'; hay {1}"],["no controller is called '{0}'; expected one of {1}","no hay un controlador '{0}'; hay {1}"],["{0} of {1} robots fell: {2} may fall, the limit is {3}.","Cayeron {0} de {1} robots: puede caer {2}, el límite es {3}."],["Of {0} robots that were held, let go and knocked {1} fell.","De {0} robots sostenidos, soltados y golpeados cayeron {1}."],["at most {0}","como máximo {0}"],["No linear margins are known.","No se conocen márgenes lineales."],["The loop is stable with any delay.","El lazo es estable con cualquier retardo."],["The loop is stable up to {0} more delay at {1}.","El lazo es estable hasta con {0} más de retardo en {1}."],["The nominal loop is unstable: a deviation doubles every {0} (|z| = {1}).","El lazo nominal es inestable: una desviación se duplica cada {0} (|z| = {1})."],["A signal {0} stronger at {1} makes the loop unstable; the limit is {2}.","Una señal un {0} mayor en {1} hace inestable el lazo; el límite es {2}."],["A signal {0} weaker at {1} makes the loop unstable; the limit is {2}.","Una señal un {0} menor en {1} hace inestable el lazo; el límite es {2}."],["{0} more delay at {1} makes the loop unstable; the limit is {2}.","Con {0} más de retardo en {1} el lazo es inestable; el límite es {2}."],["A motor is saturated {0} of the time ({1}, {2}); {3} are allowed.","Un motor está saturado el {0} del tiempo ({1}, {2}); se permite {3}."],["It rolls {0} away ({1}, {2}); {3} are allowed.","Se aleja {0} ({1}, {2}); se permite {3}."],["At rest it sways by ±{0} ({1}, {2}); {3} are allowed.","En reposo oscila ±{0} ({1}, {2}); se permite {3}."],["Left alone, the robot of the file falls after {0}.","Sin que nadie lo toque, el robot del archivo cae a los {0}."],["Left alone, {0} of {1} robots within the uncertainty of the file fall.","Sin que nadie los toque, caen {0} de {1} robots dentro de la incertidumbre del archivo."],["With the guesses as the file has them, {0} of {1} robots fall.","Con los supuestos como están en el archivo caen {0} de {1} robots."],["{0} With the guesses as the file has them, it is {1} of {2}.","{0} Con los supuestos como están en el archivo son {1} de {2}."],["Measure first: {0}.","Mida primero: {0}."],["Nothing holds its heading: the robot may turn away.","Nada mantiene su rumbo: el robot puede girar."],["Nothing holds its position or its heading: it may roll or turn away.","Nada mantiene su posición ni su rumbo: puede rodar o girar."],["Nothing holds the wheels where they are: the robot stands, and may roll away.","Nada mantiene las ruedas en su lugar: el robot está en pie y puede alejarse."],["No controller could: {0} of {1} robots have motors too weak, most for this push: {2}, {3}.","Ningún controlador podría: {0} de {1} robots tienen motores demasiado débiles, sobre todo para: {2}, {3}."],["hold at {0}","sostenido a {0}"],["knock of {0}","golpe de {0}"],["hold at {0} on a slope of {1}","sostenido a {0} en una pendiente de {1}"],["knock of {0} on a slope of {1}","golpe de {0} en una pendiente de {1}"],["low battery","batería baja"],["full battery","batería llena"],["the steering","la dirección"],["the left wheel's rate","la velocidad de la rueda izquierda"],["the right wheel's rate","la velocidad de la rueda derecha"],["the angle sensor","el sensor de ángulo"],["the forward accelerometer","el acelerómetro hacia adelante"],["the upward accelerometer","el acelerómetro hacia arriba"],["in a class, the certificate is computed on request","en una clase, el certificado se calcula cuando se pide"],["The loop is unstable: its largest pole is at |z| = {0}.","El lazo es inestable: su mayor polo está en |z| = {0}."],["{0}: unstable, so there is no margin.","{0}: inestable, así que no hay margen."],["{0}: survives {1}, and {2} or {3} of its gain.","{0}: soporta {1}, y una ganancia {2} o {3}."],["as weak as {0} %","de solo el {0} %"],["however weak","tan pequeña como se quiera"],["as strong as {0} %","de hasta el {0} %"],["however strong","tan grande como se quiera"],["{0} ms more delay at the {1}","{0} ms más de retardo en {1}"],["{0} ms more delay at {1}","{0} ms más de retardo en {1}"],["{0} ms more delay","{0} ms más de retardo"],["any delay at the {0}","cualquier retardo en {0}"],["any delay","cualquier retardo"],["a {0} has no known linear form","un controlador {0} no tiene forma lineal conocida"],["both motors","ambos motores"],["left motor","motor izquierdo"],["right motor","motor derecho"],["steering","dirección"],["gyro","giróscopo"],["compass","brújula"],["left encoder","codificador izquierdo"],["right encoder","codificador derecho"],["encoder left","codificador izquierdo"],["encoder right","codificador derecho"],["both encoders","ambos codificadores"],["accelerometer","acelerómetro"],["the gyro","el giróscopo"],["the compass","la brújula"],["the left motor","el motor izquierdo"],["the right motor","el motor derecho"],["the left encoder","el codificador izquierdo"],["the right encoder","el codificador derecho"],["low","baja"],["full","plena"],["hold in front","sostener por delante"],["hold behind","sostener por detrás"],["front","por delante"],["back","por detrás"],["knock of {0} N s","golpe de {0} N s"],["hold at {0} rad","sostener a {0} rad"],["front hold","sostener por delante"],["back hold","sostener por detrás"],["push","empuje"],["battery","batería"],["fell","cayeron"],["saturated","saturado"],["travel [m]","recorrido [m]"],["peak [rad]","máximo [rad]"],["{0} on {1}: green","{0} en {1}: verde"],["{0} on {1}: amber","{0} en {1}: ámbar"],["{0} on {1}: red","{0} en {1}: rojo"],["certify: stopped","certificado: parado"],["doctor: stopped","doctor: parado"],["calibrate: stopped","calibración: parada"],["design: stopped","diseño: parado"],["{0}: read","{0}: leído"],["nothing was recorded yet; try: let it run for a moment","todavía no se grabó nada; pruebe: déjelo andar un momento"],["there is no file '{0}' here; try: upload it again","no hay un archivo '{0}' aquí; pruebe: ábralo otra vez"],["this run","este ensayo"],["{0}: {1} rows, {2} s, every {3} ms","{0}: {1} filas, {2} s, cada {3} ms"],["Nothing found: this log can be used as it is.","No se encontró nada: este registro puede usarse como está."],["what","qué"],["channel","canal"],["evidence","prueba"],["repair","arreglo"],["error","error"],["warning","aviso"],["note","nota"],["{0} of {1} readings repeat the previous one while the channel moves ({2}; {3} expected by chance), the first near {4} s","{0} de {1} lecturas repiten la anterior mientras el canal se mueve ({2}; por azar se esperan {3}), la primera cerca de {4} s"],["{0} of the rows are at the {1}, {2}, up to {3} consecutive","{0} de las filas están en el límite ({2}), hasta {3} seguidas"],["leave these rows out when a model is fitted","dejar fuera estas filas al ajustar un modelo"],["leave it out when a model is fitted","dejarlo fuera al ajustar un modelo"],["leave these rows out when a linear model is fitted, or use one that knows the limit","dejar fuera estas filas al ajustar un modelo lineal, o usar uno que conozca el límite"],["mean {0} rad/s over {1} s: a drift of {2} rad; plausible: at most {3} rad/s","media {0} rad/s durante {1} s: una deriva de {2} rad; plausible: como máximo {3} rad/s"],["{0} counts per turn, both encoders: noise of a rate from two rows {1} rad/s, its motion {2} rad/s","{0} cuentas por vuelta, ambos codificadores: ruido de una velocidad de dos filas {1} rad/s, su movimiento {2} rad/s"],["it reads {0} from {1} to {2} s, while the other sensors move on","lee {0} de {1} a {2} s, mientras los demás sensores siguen moviéndose"],["check the sensor and its cable; leave these rows out","revisar el sensor y su cable; dejar fuera estas filas"],["{0} counts per turn: noise of a rate from two rows {1} rad/s, its motion {2} rad/s","{0} cuentas por vuelta: ruido de una velocidad de dos filas {1} rad/s, su movimiento {2} rad/s"],["the pitch amplitude is only {0} rad: resolution and friction are as large as the dynamics","la amplitud de la inclinación es solo de {0} rad: resolución y fricción son tan grandes como la dinámica"],["its difference from the gyro follows {0} (partial R² {1}); its error while accelerating reaches {2} rad","su diferencia con el giróscopo sigue a la aceleración (R² parcial {1}); su error al acelerar llega a {2} rad"],["delayed by {0} relative to the {1}, by the pendulum equation (R² {2})","retrasado {0} respecto a {1}, según la ecuación del péndulo (R² {2})"],["the wheels respond {0} ms and the gyro {1} ms after a command ({2})","las ruedas responden {0} ms y el giróscopo {1} ms después de un mando"],["the unpredictable part of the command, {0} on both sides, turns the wheels forward (t = {1})","la parte impredecible del mando gira las ruedas hacia delante (t = {1})"],["the unpredictable part of the command, {0} on both sides, turns the wheels backward (t = {1})","la parte impredecible del mando gira las ruedas hacia atrás (t = {1})"],["each motor drives the other wheel: an unpredictable left-turn command turns them right (t = {0})","cada motor mueve la otra rueda: un mando impredecible a la izquierda gira a la derecha (t = {0})"],["log at the controller's rate; one-step regression on this log is biased","registrar al ritmo del controlador; la regresión de un paso en este registro está sesgada"],["if the controller is faster, log at its rate; one-step regression on this log is biased","si el controlador es más rápido, registrar a su ritmo; la regresión de un paso en este registro está sesgada"],["if commands were held for {0} ms, the wheels would lead by {1} ms (motor equation, R² {2}): the commands changed between the rows","si los mandos se mantuvieran {0} ms, las ruedas se adelantarían {1} ms (ecuación del motor, R² {2}): los mandos cambiaron entre las filas"],["the unpredictable part of the command moves the wheels {0} (± {1}) of the distance expected if held for {2} ms: the commands changed between the rows, or friction absorbs the small ones","la parte impredecible del mando mueve las ruedas el {0} (± {1}) de lo esperado si se mantuviera {2} ms: los mandos cambiaron entre las filas, o la fricción absorbe los pequeños"],["from t = {0} s the pitch turns by {1} rad at up to {2} rad/s, {3}","desde t = {0} s la inclinación gira {1} rad a hasta {2} rad/s: una caída"],["from {0} to {1} s {2}: signs, units, delays and offsets are not judged there","de {0} a {1} s {2}: allí no se juzgan signos, unidades, retardos ni desviaciones"],["the robot lies","el robot yace"],["the robot lies after its fall","el robot yace tras su caída"],["the robot is upside down","el robot está cabeza abajo"],["the robot stands up","el robot se levanta"],["the robot is thrown, lifted or carried","el robot es lanzado, levantado o llevado"],["the robot balances nowhere in this log: no sign, unit, delay or offset can be judged","el robot no se equilibra en ningún momento de este registro: no se puede juzgar nada"],["the longest time on the wheels is from {0} to {1} s","el tiempo más largo sobre las ruedas es de {0} a {1} s"],["wheels at rest from {0} to {1} s (rows {2} to {3}): gyro noise {4} rad/s, no command; held by hand, or stuck by friction","ruedas en reposo de {0} a {1} s (filas {2} a {3}): ruido del giróscopo {4} rad/s, sin mando; sostenido con la mano, o parado por la fricción"],["wheels at rest from {0} to {1} s (rows {2} to {3}): gyro noise {4} rad/s, mean command {5}; held by hand, or stuck by friction","ruedas en reposo de {0} a {1} s (filas {2} a {3}): ruido del giróscopo {4} rad/s, mando medio {5}; sostenido con la mano, o parado por la fricción"],["wheel slip from {0} to {1} s: up to {2} rad/s² off the pendulum equation ({3} standard deviations), in both directions","deslizamiento de las ruedas de {0} a {1} s: hasta {2} rad/s² fuera de la ecuación del péndulo ({3} desviaciones típicas), en ambos sentidos"],["wheel slip at {0} s: up to {1} rad/s² off the pendulum equation ({2} standard deviations), in both directions","deslizamiento de las ruedas en {0} s: hasta {1} rad/s² fuera de la ecuación del péndulo ({2} desviaciones típicas), en ambos sentidos"],["a push at {0} s: up to {1} rad/s² off the pendulum equation ({2} standard deviations), in one direction","un empuje en {0} s: hasta {1} rad/s² fuera de la ecuación del péndulo ({2} desviaciones típicas), en un sentido"],["a push from {0} to {1} s: up to {2} rad/s² off the pendulum equation ({3} standard deviations), in one direction","un empuje de {0} a {1} s: hasta {2} rad/s² fuera de la ecuación del péndulo ({3} desviaciones típicas), en un sentido"],["remove them","quitarlas"],["keep the first row of each time","conservar la primera fila de cada instante"],["sort the rows, keep one for each time","ordenar las filas y conservar una de cada instante"],["interpolate them linearly","interpolarlas linealmente"],["resample at even times","remuestrear a intervalos iguales"],["use the parts as separate logs","usar las partes como registros separados"],["use the times of the log, as every command does, not row × period","usar los tiempos del registro, como hace cada orden, no fila × período"],["drop the channel","descartar el canal"],["check the cable and the mapped column","revisar el cable y la columna asignada"],["run it with a controller, or check the mapped column","ponerlo en marcha con un controlador, o revisar la columna asignada"],["record the robot while it stands, too","registrar el robot también mientras está de pie"],["subtract {0} rad/s","restar {0} rad/s"],["fit the angles, not their differences","ajustar los ángulos, no sus diferencias"],["take rates over several rows","calcular velocidades con varias filas"],["add a signal that makes it swing (upright excite), for a model","añadir una señal que lo haga oscilar (upright excite), para un modelo"],["fit gyro and encoders, not this estimate","ajustar giróscopo y codificadores, no esta estimación"],["multiply by −1","multiplicar por −1"],["multiply by {0}","multiplicar por {0}"],["divide by {0}","dividir entre {0}"],["shift it {0} earlier","adelantarlo {0}"],["include this dead time in the model, or shift the commands","incluir este tiempo muerto en el modelo, o desplazar los mandos"],["integrate both encoders","integrar ambos codificadores"],["differentiate it","derivarlo"],["swap left and right command","intercambiar mando izquierdo y derecho"],["exclude it from a fit","excluirlo de un ajuste"],["exclude these rows from a fit","excluir estas filas de un ajuste"],["exclude these rows from a fit, or log the push","excluir estas filas de un ajuste, o registrar el empuje"],["log a robot that balances","registrar un robot que se equilibra"],["use {0} s","usar {0} s"],["{0} of {1} readings are missing, the first at row {2}","faltan {0} de {1} lecturas, la primera en la fila {2}"],["all readings are missing","faltan todas las lecturas"],["it is {0} in all {1} rows","vale {0} en las {1} filas"],["{0} rows are missing at {1} places, the first after t = {2} s: steps of two or more periods of {3} ms","faltan {0} filas en {1} lugares, la primera tras t = {2} s: pasos de dos o más períodos de {3} ms"],["{0} from {1} samples","{0} a partir de {1} muestras"],["parameter","parámetro"],["value","valor"],["95 %","95 %"],["prior","a priori"],["unit","unidad"],["what the log tells","lo que dice el registro"],["visible","visible"],["prior dominates","domina el a priori"],["at its bound","en su límite"],["not fitted","no ajustado"],["refused","rechazado"],["weight moment","momento del peso"],["weight moment/a22","momento del peso/a22"],["unstable pole","polo inestable"],["wheel mass","masa de una rueda"],["wheel radius","radio de la rueda"],["wheel inertia","inercia de una rueda"],["body mass","masa del cuerpo"],["track","ancho de vía"],["com height","altura del centro de masa"],["pitch inertia","inercia de cabeceo"],["yaw inertia","inercia de guiñada"],["roll inertia","inercia de balanceo"],["rotor inertia","inercia del rotor"],["gear ratio","relación de transmisión"],["motor resistance","resistencia del motor"],["back emf","constante contraelectromotriz"],["torque constant","constante de par"],["motor friction","fricción del motor"],["wheel friction","fricción de la rueda"],["coulomb friction","fricción seca"],["rolling friction","resistencia a la rodadura"],["stiction rate","velocidad de suavizado"],["gravity","gravedad"],["body depth","fondo del cuerpo"],["body height","altura del cuerpo"],["speed lag","retardo de la velocidad"],["acceleration limit","límite de aceleración"],["slip torque","par de deslizamiento"],["asymmetry","asimetría de los motores"],["dead zone","zona muerta"],["constant command","mando constante"],["roll fraction","fracción de balanceo"],["motor gain","ganancia del motor"],["motor damping","amortiguamiento del motor"],["delay/gyro−encoder","retardo giróscopo−codificador"],["delay/{0}","retardo/{0}"],["command","mando"],["encoder","codificador"],["TWIPR (small BILBO): torque-controlled motors, centre of mass just above the axle.","TWIPR (BILBO pequeño): motores controlados en par, centro de masa apenas sobre el eje."],["The NXTway-GS design rebuilt with LEGO EV3 parts and motors, on small wheels of 21.5 mm radius; on large wheels: ev3way-large-wheels.","El diseño NXTway-GS con piezas y motores LEGO EV3, sobre ruedas pequeñas de 21,5 mm de radio; con ruedas grandes: ev3way-large-wheels."],["Yamamoto's NXTway-GS, the LEGO NXT robot whose published table Herrera et al. (2015) start from.","El NXTway-GS de Yamamoto, el robot LEGO NXT de cuya tabla publicada parten Herrera et al. (2015)."],["NXTway-GS with a rotor inertia of the size that is measured, 150 times the published estimate.","NXTway-GS con una inercia del rotor como la que se mide, 150 veces la estimación publicada."],["The EV3way design on wheels of about 45 mm radius: the LEGO EV3 robot of the published logs of sim2real-ev3way.","El diseño EV3way sobre ruedas de unos 45 mm de radio: el robot LEGO EV3 de los registros publicados de sim2real-ev3way."],["The robot behind the printed linear model of Herrera et al. (2015): twice as tall as NXTway-GS, on half the wheels.","El robot tras el modelo lineal impreso de Herrera et al. (2015): el doble de alto que NXTway-GS, sobre ruedas de la mitad."],["this log is of a robot whose commands are in {0}; {1} takes {2}. Choose the log's robot in the tab Robot, then press {3} again.","las órdenes de este registro están en {0}; las de {1}, en {2}. Elija en la pestaña Robot el robot del registro y presione {3} otra vez."],["Calibrate","Calibrar"],["Compare","Comparar"],["Doctor","Doctor"],["What looks like a push at {0} s bends the numbers, since no push is known. The terminal's “upright calibrate … --between-knocks” leaves the pushes out.","Lo que parece un empujón en {0} s desvía los números, pues no se conoce ningún empujón. La orden “upright calibrate … --between-knocks” de la terminal omite los empujones."],["Outside of what was known before: {0}. Check the file, and the log.","Fuera de lo que se sabía antes: {0}. Revise el archivo y el registro."],["The readings hardly change with {0} together: the log does not separate them.","Las lecturas casi no cambian con {0} a la vez: el registro no los distingue."],["{0} up","{0} (más)"],["{0} down","{0} (menos)"],["{0} ({1} times the file)","{0} ({1} veces el archivo)"],["{0} by {1}","{0} por {1}"],["The innovations are not white: the model leaves something out. The effective sample size is {0} of the readings, and the intervals are on average {1} times as wide as those of a right model.","Las innovaciones no son blancas: el modelo omite algo. El tamaño efectivo de la muestra es el {0} de las lecturas. Los intervalos son en promedio {1} veces más anchos que los de un modelo correcto."],["The log contradicts the stated value of {0} deviations (more than {1}): measure it again, or start from another robot; half seconds are better predicted as they stand by other presets (this file: R² {2}): {3}.","El registro contradice el valor indicado: {0} desviaciones (más de {1}). Mídalo otra vez, o parta de otro robot; otros robots de fábrica predicen mejor los medios segundos tal como están (este archivo: R² {2}): {3}."],["The log contradicts the stated value of {0} deviations (more than {1}): measure it again, or start from another robot.","El registro contradice el valor indicado: {0} desviaciones (más de {1}). Mídalo otra vez, o parta de otro robot."],["The gyro is filtered: low-pass at {0} Hz ({1} to {2}), damping {3}. With it the log is {4} nats likelier, its priors counted. Part of the gyro's delay is in that filter.","El giroscopio está filtrado: paso bajo en {0} Hz ({1} a {2}), amortiguamiento {3}. Con él el registro es {4} nats más probable, contadas sus distribuciones previas. Parte del retardo del giroscopio está en ese filtro."],["Gyro resonance: {0} Hz ({1} to {2}), damping {3}. With it the log is {4} nats likelier, its priors counted. Something between frame and gyro swings: fix the sensor or the frame.","Resonancia del giroscopio: {0} Hz ({1} a {2}), amortiguamiento {3}. Con ella el registro es {4} nats más probable, contadas sus distribuciones previas. Algo entre el chasis y el giroscopio oscila: sujete el sensor o el chasis."],["The gyro is filtered: low-pass at {0} Hz ({1} to {2}), damping {3}. Part of the gyro's delay is in that filter.","El giroscopio está filtrado: paso bajo en {0} Hz ({1} a {2}), amortiguamiento {3}. Parte del retardo del giroscopio está en ese filtro."],["Gyro resonance: {0} Hz ({1} to {2}), damping {3}. Something between frame and gyro swings: fix the sensor or the frame.","Resonancia del giroscopio: {0} Hz ({1} a {2}), amortiguamiento {3}. Algo entre el chasis y el giroscopio oscila: sujete el sensor o el chasis."],["The driver takes {0} V ({1} to {2}) off each command. With it the log is {3} nats likelier, its prior counted.","La etapa de potencia quita {0} V ({1} a {2}) a cada orden. Con esa pérdida el registro es {3} nats más probable, contada su distribución previa."],["The gyro reads {0} ({1} to {2}) of the yaw rate too: it is tilted by {3}°. With it the log is {4} nats likelier, its prior counted.","El giroscopio mide también {0} ({1} a {2}) de la velocidad de giro (guiñada): está inclinado {3}°. Con esa parte el registro es {4} nats más probable, contada su distribución previa."],["the log and the robot's file would agree if {0}: measure it again","el registro y el archivo del robot concordarían si {0}: mídalo otra vez"],["the log and the robot's file would agree if {0}: measure these again","el registro y el archivo del robot concordarían si {0}: mídalos otra vez"],["The log and the robot's file would agree if {0}. Measure it again.","El registro y el archivo del robot concordarían si {0}. Mídalo otra vez."],["The log and the robot's file would agree if {0}. Measure these again: the intervals allow for each.","El registro y el archivo del robot concordarían si {0}. Mídalos otra vez: los intervalos cubren cada caso."],["{0} were {1} (the file: {2})","{0} fuera {1} (el archivo: {2})"],["{0}, or if {1}","{0}, o si {1}"],["Or the motors give another torque than commanded: give gear_ratio a spread in the robot's file.","O los motores dan otro par que el pedido: dé a gear_ratio una dispersión en el archivo del robot."],["The log may be of another robot than the file; half seconds are better predicted as they stand by other presets (this file: R² {0}): {1}.","El registro puede ser de otro robot que el archivo; otros robots de fábrica predicen mejor los medios segundos tal como están (este archivo: R² {0}): {1}."],["{0}, or {1}","{0}, o {1}"],["In {0} of the half-second free simulations the model falls where the robot did not.","En el {0} de las simulaciones libres de medio segundo el modelo cae donde el robot no cayó."],["One encoder, or two that agree to a step or two, tell nothing of turning: asymmetry, track, yaw and roll inertia stay.","Un codificador, o dos que difieren en uno o dos pasos como máximo, no dicen nada del giro: asimetría, ancho de vía e inercias de guiñada y de balanceo no cambian."],["Too quiet for an inertia: the pitch rate moves by {0} steps of its gyro (rms), not {1}. Inertias and the height of the centre of mass stay at their prior; excite the robot, and log again.","Demasiado quieto para una inercia: la velocidad de inclinación varía {0} pasos de su giróscopo (rms), no {1}. Las inercias y la altura del centro de masa quedan como estaban. Excite el robot y registre otra vez."],["{0} of {1} rows came late: the program's period is {2} ms, its rows are {3} ms apart.","{0} de {1} filas llegaron tarde: el período del programa es de {2} ms, sus filas distan {3} ms."],["Only {0} to {1} is used, where the robot is on its wheels. Left out: {2}.","Solo se usa de {0} a {1}, donde el robot está sobre sus ruedas. Se omite: {2}."],["the numbers of the robot's file predict half seconds of this log better than the fitted ones do: the log has too little in it, or something that no robot of this kind does","los números del archivo del robot predicen los medios segundos de este registro mejor que los ajustados: el registro dice muy poco, o algo que ningún robot así hace"],["the log is of another robot than the file, which says {0}: measure these, or choose another robot; half seconds are better predicted as they stand by other presets (this file: R² {1}): {2}","el registro es de otro robot que el archivo, que dice {0}: mídalos, o elija otro robot; otros robots de fábrica predicen mejor los medios segundos tal como están (este archivo: R² {1}): {2}"],["the log is of another robot than the file, which says {0}: measure these, or choose another robot","el registro es de otro robot que el archivo, que dice {0}: mídalos, o elija otro robot"],["{0} ± {1}, the log {2}","{0} ± {1}, y el registro {2}"],["{0}, {1} deviations more than a robot like the file's may lose: its back_emf, which counts at the wheel, behind the gear, its torque_constant or its gear_ratio is likely wrong","{0}, {1} desviaciones más de lo que pierde un robot como el del archivo: back_emf, torque_constant o gear_ratio deben de estar mal"],["{0}: half a second of free simulation predicts worse than the mean does (R² {1}), worst at t = {2} s; likely a robot that falls where this one did not: another robot, a flipped sign or a wrong unit","{0}: medio segundo de simulación libre predice peor que la media (R² {1}), lo peor en t = {2} s; probablemente un robot que cae donde este no cayó: otro robot, un signo invertido o una unidad equivocada"],["{0}: half a second of free simulation predicts worse than the mean does (R² {1}), worst at t = {2} s; likely a delay: {3} readings later","{0}: medio segundo de simulación libre predice peor que la media (R² {1}), lo peor en t = {2} s; probablemente un retardo: {3} lecturas después"],["{0}: half a second of free simulation predicts worse than the mean does (R² {1}), worst at t = {2} s; likely a delay: {3} readings earlier","{0}: medio segundo de simulación libre predice peor que la media (R² {1}), lo peor en t = {2} s; probablemente un retardo: {3} lecturas antes"],["{0}: half a second of free simulation predicts worse than the mean does (R² {1}), worst at t = {2} s; likely a flipped sign","{0}: medio segundo de simulación libre predice peor que la media (R² {1}), lo peor en t = {2} s; probablemente un signo invertido"],["{0}: half a second of free simulation predicts worse than the mean does (R² {1}), worst at t = {2} s; likely a wrong unit: the readings are {3} times the prediction","{0}: medio segundo de simulación libre predice peor que la media (R² {1}), lo peor en t = {2} s; probablemente una unidad equivocada: las lecturas son {3} veces la predicción"],["{0}: half a second of free simulation predicts worse than the mean does (R² {1}), worst at t = {2} s; likely wheels that slip, another controller period, or a robot unlike the file","{0}: medio segundo de simulación libre predice peor que la media (R² {1}), lo peor en t = {2} s; probablemente ruedas que deslizan, otro período del controlador, o un robot distinto del archivo"],["the filter loses the robot from every start; expected a log of the named robot, balancing; likely another robot, a flipped sign or a wrong unit. Press Doctor: it examines the log.","el filtro pierde al robot desde todo comienzo. Probablemente es otro robot, un signo invertido o una unidad equivocada. Presione Doctor: examina el registro."],["the commands never change; expected motors at work; likely a log of a robot switched off, or of motors at one speed","los mandos nunca cambian; se esperaban motores en marcha. Probablemente el robot estaba apagado, o sus motores a una sola velocidad"],["the log has no {0}; expected encoders, a gyro or a tilt, and commands in {1}. The terminal's “upright doctor LOG --write-mapping m.toml” drafts names for its columns.","el registro no tiene {0}; se esperaban codificadores, un giróscopo o una inclinación, y mandos en {1}. La orden “upright doctor LOG --write-mapping m.toml” de la terminal propone nombres para sus columnas."],["encoders","codificadores"],["commands","mandos"],["battery voltage (its commands are a duty)","tensión de la batería (sus mandos son un ciclo de trabajo)"],["{0} and no {1}","{0} ni {1}"],["the log's commands are a duty, and of what voltage is not known; expected {0}. The terminal's “upright doctor LOG --fix NEW.csv” repairs what it can.","los mandos del registro son un ciclo de trabajo, y no se sabe de qué tensión; se esperaban {0}. La orden “upright doctor LOG --fix NEW.csv” de la terminal repara lo que puede."],["the clock jumps by {0} s after t = {1} s, at row {2}; expected one run without a pause over {3} s; likely two recordings, or a clock that was set. The terminal's “upright doctor LOG --fix NEW.csv” repairs what it can.","el reloj salta {0} s tras t = {1} s, en la fila {2}; se esperaba un ensayo sin pausa de más de {3} s. La orden “upright doctor LOG --fix NEW.csv” de la terminal repara lo que puede."],["the log is uneven; expected steps near {0} s; likely dropped samples. The terminal's “upright doctor LOG --fix NEW.csv” repairs what it can.","el registro es irregular; se esperaban pasos de unos {0} s. La orden “upright doctor LOG --fix NEW.csv” de la terminal repara lo que puede."],["the log has {0} samples; expected at least {1} to calibrate from","el registro tiene {0} muestras; para calibrar se esperan al menos {1}"],["the log lasts {0} s; expected {1} s or more","el registro dura {0} s; se esperan {1} s o más"],["raw sensors that move: {0}; expected both encoders and a gyro; likely a plug that is out, since {1} never changes. The terminal's “upright doctor LOG --write-mapping m.toml” drafts names for its columns.","sensores que se mueven: {0}; se esperaban ambos codificadores y un giróscopo. Tal vez hay un enchufe suelto: {1} nunca cambia. La orden “upright doctor LOG --write-mapping m.toml” de la terminal propone nombres para sus columnas."],["raw sensors that move: {0}; expected both encoders and a gyro. The terminal's “upright doctor LOG --write-mapping m.toml” drafts names for its columns.","sensores que se mueven: {0}; se esperaban ambos codificadores y un giróscopo. La orden “upright doctor LOG --write-mapping m.toml” de la terminal propone nombres para sus columnas."],["the robot is never on its wheels in this log: {0}; expected a robot that balances. Press Doctor: it examines the log.","el robot nunca está sobre sus ruedas en este registro; se esperaba un robot que se equilibra. Presione Doctor: examina el registro."],["the log has {0} rows; expected at least {1} to judge a motion","el registro tiene {0} filas; para juzgar un movimiento se esperan al menos {1}"],["the log has 1 row; expected at least {0} to judge a motion","el registro tiene 1 fila; para juzgar un movimiento se esperan al menos {0}"],["there are no rows of numbers; likely an empty recording","no hay filas de números; tal vez la grabación está vacía"],["there are no rows below the header; likely an empty recording","no hay filas bajo el encabezado; tal vez la grabación está vacía"],["the file is empty; likely a recording that was never closed","el archivo está vacío; tal vez la grabación nunca se cerró"],["the file is not text; likely a binary file under this name; try: export it as CSV","el archivo no es texto; pruebe: expórtelo como CSV"],["no {0} is recognised among {1}. The terminal's “upright doctor LOG --write-mapping m.toml” drafts names for its columns.","entre {1} no se reconoce ningún {0}. La orden “upright doctor LOG --write-mapping m.toml” de la terminal propone nombres para sus columnas."],["time","tiempo"],["the process that computed it died, perhaps of too large a file","el proceso que lo calculaba terminó, tal vez por un archivo demasiado grande"],["it took longer than {0} s and was stopped","tardó más de {0} s y se detuvo"],["After this log {0} are less certain than before, since the runs differ by more than that. The terminal's “upright calibrate … --known NAME” takes as exact what you measured.","Tras este registro {0} son menos seguro que antes, pues los ensayos difieren más que eso. La orden “upright calibrate … --known NAME” de la terminal toma por exacto lo que usted midió."],["After this log {0} is less certain than before, since the runs differ by more than that. The terminal's “upright calibrate … --known NAME” takes as exact what you measured.","Tras este registro {0} es menos seguro que antes, pues los ensayos difieren más que eso. La orden “upright calibrate … --known NAME” de la terminal toma por exacto lo que usted midió."],["After this log {0} are less certain than before, because of the model's error. The terminal's “upright calibrate … --known NAME” takes as exact what you measured.","Tras este registro {0} son menos seguro que antes, por el error del modelo. La orden “upright calibrate … --known NAME” de la terminal toma por exacto lo que usted midió."],["After this log {0} is less certain than before, because of the model's error. The terminal's “upright calibrate … --known NAME” takes as exact what you measured.","Tras este registro {0} es menos seguro que antes, por el error del modelo. La orden “upright calibrate … --known NAME” de la terminal toma por exacto lo que usted midió."],["After this log {0} are less certain than before, since the log contradicts the file, and any of its numbers may be wrong. The terminal's “upright calibrate … --known NAME” takes as exact what you measured.","Tras este registro {0} son menos seguros que antes, pues el registro contradice el archivo y cualquiera de sus números puede estar mal. La orden “upright calibrate … --known NAME” de la terminal toma por exacto lo que usted midió."],["After this log {0} is less certain than before, since the log contradicts the file, and any of its numbers may be wrong. The terminal's “upright calibrate … --known NAME” takes as exact what you measured.","Tras este registro {0} es menos seguro que antes, pues el registro contradice el archivo y cualquiera de sus números puede estar mal. La orden “upright calibrate … --known NAME” de la terminal toma por exacto lo que usted midió."],["Other fits predict half seconds equally well: the intervals allow for each of them.","Otros ajustes predicen igual de bien medio segundo: los intervalos admiten cada uno de ellos."],["{0}. In a terminal: {1}.","{0}. En una terminal: {1}."],["Nothing to hand in yet: press Stand up, push the robot, then Hand in within a minute.","Aún no hay nada que entregar: presione Poner de pie, empuje el robot y entregue antes de un minuto."],["{0}; try: {1}","{0}; pruebe: {1}"],["the token is missing or wrong","la clave falta o no es correcta"],["open the address that your teacher shows","abra la dirección que muestra su docente"],["your name is missing","falta su nombre"],["write a name, so that the board can show it","escriba un nombre para que aparezca en la clasificación"],["every place is taken","todos los lugares están ocupados"],["close another page of the lab first","cierre antes otra página del laboratorio"],["too many messages","demasiados mensajes"],["wait a moment and reload the page","espere un momento y recargue la página"],["wait a minute and reload the page","espere un minuto y recargue la página"],["too many new robots from this address","demasiados robots nuevos desde esta dirección"],["upload it again","ábralo otra vez"],["kit '{0}' drives by {1}; expected {2}, as the robot","la electrónica '{0}' actúa por {1}; se esperaba {2}, como en el robot"],["voltage","tensión"],["torque","par"],["speed","velocidad"],["pid asks a torque for a lean, and '{0}' is driven by wheel speed; expected another drive; try: lqg, hinf or mpc, or a cascade of your own to an acceleration","pid pide un par por una inclinación, y '{0}' se mueve por velocidad de rueda; se esperaba otro accionamiento; pruebe lqg, hinf o mpc, o una cascada propia hasta una aceleración"]]`),wr={en:Tr,es:AA};let Ei=Tr;function Hp(){return Object.keys(wr).find(i=>wr[i]===Ei)??"en"}function hd(i){Ei=wr[i]??Tr,document.documentElement.lang=Hp(),document.title=Ei.title}function Ph(){return Ei}function N(i,e={}){return Ei[i].replace(/\{(\w+)\}/g,(t,n)=>CA(String(e[n]??"")))}function fn(i){const e=Ei[i];return typeof e=="string"?e:i}function $i(i){return Ei.decimal==="."?i:i.replace(/(\d)\.(?=\d)/g,`$1${Ei.decimal}`)}function oi(i,e){return $i(i.toFixed(e).replace("-","−"))}function CA(i){return/^[−-]?\d+\.\d+$/.test(i)?$i(i):i}const PA=i=>i.replace(/[.*+?^${}()|[\]\\]/g,"\\$&"),ud=i=>i.replace(/\{\d\}/g,"").length,Vp=[...RA].sort(([i],[e])=>ud(e)-ud(i)).map(([i,e])=>[new RegExp(`^${PA(i).replace(/\\\{\d\\\}(?= at )/g,"(.+)").replace(/\\\{\d\\\}/g,"(.+?)")}$`,"s"),e]);function Bt(i){if(Ei===Tr)return i;for(const[e,t]of Vp){const n=e.exec(i);if(n)return t.replace(/\{(\d)\}/g,(s,o)=>LA(n[Number(o)+1]))}return $i(i)}function LA(i){const e=i.split(/, | and /).map(n=>n.replaceAll("_"," "));if(!e.every(n=>Lh(n)||/^[\d.…]+$/.test(n)))return Bt(i);const t=i.includes(" and ")?e.pop():void 0;return[e.map(Bt).join(", "),...t===void 0?[]:[Bt(t)]].join(" y ")}function Lh(i){return Ei===Tr||Vp.some(([e])=>e.test(i))}function NA(i,e){const t=Na(e);return N("jobStopped",{job:fn(i),why:/[.!?…]$/.test(t)?t:`${t}.`})}function Na(i){return Lh(i)?Bt(i):N("original",{text:i})}function D(i,e={},...t){const n=document.createElement(i);for(const[s,o]of Object.entries(e))s.startsWith("on")?n.addEventListener(s.slice(2),o):s.includes("-")||s==="role"||s==="for"||s==="list"?n.setAttribute(s,String(o)):o!==void 0&&(n[s]=o);return n.append(...t.filter(s=>!!s)),n}function $e(i,...e){Hs(()=>i.replaceChildren(...e.filter(t=>!!t)))}function Hs(i){const e=document.activeElement?.dataset?.key;i(),e&&document.activeElement===document.body&&document.querySelector(`[data-key="${e}"]`)?.focus({preventScroll:!0})}const Gp=new WeakMap;function hn(i){const e=D("span",{className:"said"},i());return Gp.set(e,i),e}function Da(i){for(const e of i.querySelectorAll(".said"))e.textContent=Gp.get(e)?.()??""}function st(i,e,t={}){return D("button",{type:"button",onclick:e,...t},i)}let dd=0;function $s(i){return dd+=1,`${i}-${dd}`}function Wp(i,e){const t=D("input",{type:"text",inputMode:"decimal",autocomplete:"off",className:"number",...e,onchange:()=>{const s=t.value.trim().replace("−","-").replace(",","."),o=s!==""&&Number.isFinite(Number(s));t.setAttribute("aria-invalid",String(!o)),o&&(n(Number(s)),i(Number(s)))}}),n=s=>t.value=$i(String(s).replace("-","−"));return{root:t,set:s=>{document.activeElement!==t&&(n(s),t.removeAttribute("aria-invalid"))}}}function Zn(i,e,t){const n=$s("slider"),s=p=>e.log?Math.log(p):p,o=p=>e.log?Math.exp(p):p,r=s(e.high)-s(e.low),a=D("input",{type:"range",id:n,min:String(s(e.low)),max:String(s(e.high)),step:String(e.step??r/200),"data-key":e.key??""}),l=p=>!e.log&&Math.abs(p)<1e-6*r?0:p,c=e.typed===void 0?null:Wp(p=>{a.value=String(s(p)),a.setAttribute("aria-valuetext",e.show(p)),t(p)},{"aria-label":i,"data-key":`${e.key??""}-typed`}),h=c?D("span",{className:"typed"},c.root,` ${e.typed}`):D("output",{for:n}),u=p=>{c?c.set(Number(p.toPrecision(4))):h.textContent=e.show(p),a.setAttribute("aria-valuetext",e.show(p))};a.addEventListener("input",()=>{const p=l(o(Number(a.value)));u(p),t(p)});const d=p=>{document.activeElement!==a&&(a.value=String(s(Math.max(p,e.log?e.low:-1/0)))),u(p)};return{root:D("div",{className:"slider"},D("label",{for:n},i),h,a),set:d}}function fs(i,e,t,n,s=""){const o=$s("select"),r=D("select",{id:o,"data-key":s,onchange:()=>n(r.value)},...e.map(([a,l])=>D("option",{value:a,selected:a===t},l)));return D("div",{className:"choice"},D("label",{for:o},i),r)}function at(i,e=3){return Number.isFinite(i)?$i(ls(String(Number(i.toPrecision(e))))):"∞"}function Nh(i){return`${$i(ls(String(Number((i*180/Math.PI).toFixed(1)))))}°`}function ls(i){const e=(t,n)=>` ×10${t==="-"?"⁻":""}${n.replace(/\d/g,s=>"⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(s)])}`;return i.replace(/(?<=\d)e([+-]?)0*(\d+)\b/g,(t,n,s)=>e(n,s)).replace(/(?<=^|[\s(…])-(?=\.?\d)/g,"−")}function Ia(i,e,t=""){const n=i.length?D("thead",{},D("tr",{},...i.map(o=>D("th",{scope:"col"},o)))):null,s=D("tbody",{},...e.map(o=>D("tr",{},...o.map(r=>D("td",{},r)))));return D("div",{className:"table",tabIndex:0,"data-key":t&&`table-${t}`},D("table",{className:t},n,s))}function Dh(i,e){let t=0,n=null;return(...s)=>{n=s,!t&&(e(...s),n=null,t=window.setTimeout(function o(){if(t=0,n){const r=n;n=null,e(...r),t=window.setTimeout(o,i)}},i))}}const DA={twin:"#0072b2",nonlinear:"#d55e00",linear:"#00805c",calibrated:"#a0478a",published:"#6b6b00"},IA={twin:"#56b4e9",nonlinear:"#f2843c",linear:"#2fc79b",calibrated:"#dd93bd",published:"#c9c95a"},kA={nonlinear:[7,4],linear:[2,3],calibrated:[9,3,2,3],published:[12,5]};function UA(){return document.documentElement.dataset.theme==="dark"}function cs(i){const e=i==="nonlinear"&&"uprightExport"in globalThis?"twin":i;return(UA()?IA:DA)[e]??"#888888"}function Ih(i,e){return i===e[0]?[]:kA[i]??[]}function ps(){const i=getComputedStyle(document.documentElement),e=t=>i.getPropertyValue(t).trim();return{text:e("--ink"),soft:e("--soft"),grid:e("--grid"),push:e("--push")}}const fd={front:[0,.5],back:[-.5,0],impulse:[-20,20],pull_left:[-100,100],pull_right:[-100,100],tilt:[-1.2,1.2]},FA=.5;class OA{push=null;kept="noPush";hand={from:0,at:0,force:0,impulse:0,on:!1};note(e,t){e.kind==="Strike"?this.name([e.what,e.size]):e.kind==="StandUp"&&e.pitch?this.name(["tilt",e.pitch]):e.kind==="Drag"&&this.drag(e.force,t)}name(e){[this.push,this.kept]=[e,e?"namedPush":"noPush"]}drag(e,t){const{hand:n}=this;if(!n.on&&!e)return;n.on||Object.assign(n,{from:t,at:t,force:0,impulse:0,on:!0}),n.impulse+=n.force*(t-n.at),[n.at,n.force,n.on]=[t,e,e!==0];const s=t-n.from<=FA;[this.push,this.kept]=s?[["impulse",Number(n.impulse.toPrecision(4))],"knockPush"]:[null,"heldPush"]}}function zA(i){const[e,t]=(new URLSearchParams(i.replace(/^#/,"")).get("push")??"").split(":"),[n,s]=Object.hasOwn(fd,e)?fd[e]:[0,-1];return Number(t)>=n&&Number(t)<=s?[e,Number(t)]:null}function BA([i,e]){return i==="tilt"?{kind:"StandUp",pitch:e}:{kind:"Strike",what:i,size:e}}const ya={slope:[-.35,.35],noise:[0,20],delay:[-1,.2],voltage:[-1,60],dead_zone:[-1,5],grip:[.02,10],seed:[0,2**31],payload:[0,5],payload_height:[0,1]},kh=Object.keys(ya),$p={gains:6,largest:7},pd=40,qp=i=>new URLSearchParams(i.replace(/^#/,"")),$r=i=>i.length>pd?i.slice(0,pd)+"…":i,Sl=i=>String(Number(i.toPrecision(6)));function ka(i){const e=["robot","controller","kit","bodies","numbers","push",...kh,...Object.keys($p)];return[...qp(i).keys()].some(t=>e.includes(t))}function HA(i,e,{usual:t,robots:n,keys:s}){const o=new URLSearchParams({robot:i.robot,controller:i.controller}),r=(l,c)=>s.includes(l)&&o.set(l,c);i.kit!==n[i.robot]?.kit&&r("kit",i.kit),i.controller==="gains"&&i.gains.length&&r("gains",i.gains.map(Sl).join()),i.largest.length&&r("largest",i.largest.map(Sl).join()),i.drive&&r("drive",i.drive),Object.keys(i.numbers).length&&r("numbers",Object.entries(i.numbers).map(([l,c])=>`${l}:${String(c)}`).join());for(const l of kh)i[l]!==t[l]&&r(l,Sl(i[l]));const a=i.bodies.filter(l=>l!=="calibrated");return a.length&&a.join()!==t.bodies.join()&&r("bodies",a.join()),e&&o.set("push",`${e[0]}:${Number(e[1].toPrecision(4))}`),"#"+o.toString().replaceAll("%2C",",").replaceAll("%3A",":")}function VA(i,e){const t=qp(i),[n,s]=[t.get("robot")??"",t.get("controller")??""],o=GA(t.get("numbers")??"",e.parameters),r=e.keys.includes("drive")&&t.has("drive")&&Object.keys(o).length===e.parameters.length,a=Object.hasOwn(e.robots,n),l={...e.usual,robot:a||n&&r?n:e.usual.robot},c=e.robots[l.robot]??e.robots[e.usual.robot];c.controllers.includes(s)&&(l.controller=s),l.kit=c.kit??l.kit;const h=(_,[m,f])=>_.trim()&&Number(_)>=m&&Number(_)<=f?Number(_):void 0,u=(_,m)=>[_.split(",").map(Number)].find(f=>f.length===m&&f.every(Number.isFinite)),d={...Object.fromEntries(kh.map(_=>[_,m=>h(m,ya[_])])),...Object.fromEntries(Object.entries($p).map(([_,m])=>[_,f=>u(f,m)])),seed:_=>h(Number.isInteger(Number(_))?_:"",ya.seed),payload:_=>h(_,c.load===void 0?ya.payload:c.load?[c.load.payload,c.load.payload]:[0,0]),kit:_=>e.kits.find(m=>m===_),drive:_=>["voltage","torque","speed"].find(m=>m===_),numbers:_=>Object.keys(o).length===_.split(",").length?o:void 0,bodies:_=>[e.bodies.filter(m=>_.split(",").includes(m))].find(m=>m.length===_.split(",").length)},p=[];for(const[_,m]of t){if(!Object.hasOwn(d,_))continue;const f=e.keys.includes(_)?d[_](m):void 0;f===void 0?p.push($r(`${_}=${m}`)):Object.assign(l,{[_]:f})}const g=zA(i);return t.has("push")&&!g&&p.push($r(`push=${t.get("push")??""}`)),{setup:l,push:g,left:p,robot:l.robot===n?"":$r(n),controller:l.controller===s?"":$r(s)}}function GA(i,e){const t=i.split(",").map(n=>n.split(":"));return Object.fromEntries(t.filter(([n,s])=>e.includes(n)&&s?.trim()&&Number.isFinite(Number(s))).map(([n,s])=>[n,Number(s)]))}function WA(i){return/[#&]token=([\w-]+)/.exec(i)?.[1]??""}const $A=8,Gi={robot:"nxtway-gs",numbers:{},drive:"",kit:"nxt",noise:1,delay:-1,voltage:-1,dead_zone:-1,grip:10,bodies:["twin","nonlinear","linear"],controller:"lqg",largest:[],gains:[],payload:0,payload_height:.15,slope:0,seed:0},qs=["pitch","pitch_rate","wheel","wheel_rate","yaw","yaw_rate"],Uh=["rad","rad/s","rad","rad/s","rad","rad/s"],Vs=["ψ","ψ̇","θ","θ̇","φ","φ̇"],el=.02,md=3200,qA=.15,gd=1e3,XA=.03,[jA,YA]=[.1,2],[KA,_d]=[2,.05],ZA=["bodies","payload","payload_height","slope","grip","seed"];function qr(i){return JSON.stringify(Object.entries(i).filter(([e])=>!ZA.includes(e)))}function vd({robot:i,drive:e,kit:t,controller:n}){return[i,e,t,n].join()}function bd(i){return JSON.stringify(Object.entries(i).sort(([e],[t])=>e<t?-1:1))}class Fh{t=[];x=[];estimate=[];volts=[[],[]];saturated=[];marks=[];breaks=[];other=!1;from=-1/0;begin(e){this.reset(this.x.length),this.from=e,this.other=!1}reset(e){this.from=-1/0,this.t=[],this.x=Array.from({length:e},()=>qs.map(()=>[])),this.estimate=[],this.volts=[[],[]],this.saturated=[],this.breaks=[],this.marks=[]}add(e){const t=this.t.at(-1);if(!(e.t<=this.from||t!==void 0&&e.t<t)){if(e.t===t){const n=this.t.length-1;if(e.x.length!==this.x.length||this.x.every((s,o)=>s.every((r,a)=>r[n]===e.x[o][a])))return;this.pop()}e.x.length!==this.x.length&&this.reset(e.x.length),this.push(e.t,e.x,e.e[0]??NaN,e.x[0][6],e.x[0][7],e.s),this.t.length>md+400&&this.cut(this.t.length-md)}}push(e,t,n,s,o,r){(this.other||this.jumps(e,t))&&this.breaks.push([this.t.at(-1)??e,e]),this.other=!1,this.t.push(e),t.forEach((a,l)=>this.x[l].forEach((c,h)=>c.push(a[h]))),this.estimate.push(n),this.volts[0].push(s),this.volts[1].push(o),this.saturated.push(r)}pop(){for(const e of[this.t,...this.x.flat(),this.estimate,...this.volts,this.saturated])e.pop();this.other=!0}jumps(e,t){const[n,s]=[this.t.length-1,e-(this.t.at(-1)??e)],o=(r,a,l)=>Math.abs(r[l]-a[l][n])>jA+YA*s*Math.max(Math.abs(r[l+1]),Math.abs(a[l+1][n]));return n>=0&&t.some((r,a)=>[0,2,4].some(l=>o(r,this.x[a],l)))}fill(e,t){if(!t.length)return;const n=Math.floor(t[0].length/6);(n!==this.x.length||(this.t.at(-1)??0)>e.at(-1)+1)&&this.reset(n);const s=new Fh;s.reset(n);let o=0;const r=a=>{for(;o<e.length&&e[o]<a-.001;o+=1){if(e[o]<=this.from||e[o]-(s.t.at(-1)??-1/0)<XA)continue;const[l,c]=[t[o],t[o].slice(6*n)];s.push(e[o],Array.from({length:n},(h,u)=>l.slice(6*u,6*u+6)),c[0],c[1],c[2],c[3])}};this.t.forEach((a,l)=>{r(a),s.push(a,this.x.map(c=>c.map(h=>h[l])),this.estimate[l],this.volts[0][l],this.volts[1][l],this.saturated[l])}),r(1/0),s.breaks.push(...this.breaks),s.marks.push(...this.marks),Object.assign(this,s,{from:this.from,other:this.other})}until(e){let t=this.t.length;for(;t>0&&this.t[t-1]>=e;)t-=1;for(const n of this.all())n.length=t;this.marks=this.marks.filter(n=>n.t<e)}cut(e){for(const t of this.all())t.splice(0,e);this.marks=this.marks.filter(t=>t.t>=this.t[0])}all(){return[this.t,this.estimate,...this.volts,this.saturated,...this.x.flat()]}}const Xp={kind:"Light",light:"none",reasons:[],delay:null,delay_at:"",gain_low:null,low_at:"",gain_high:null,high_at:"",met:null};class JA{snapshot=null;traces=new Fh;changed=null;catalogue=null;analysed=null;equations=null;lit=null;trying=null;jobs=new Set;ceiling=null;board=null;found=null;certified=null;role="alone";session="";files="";invite="";setup=Gi;last=new OA;corrected=()=>{};say=()=>{};recorded=0;send=()=>{};listeners=[];sent=null;waiting=!1;asked=[];fresh=!1;lain=null;recalled=-gd;rest;missing=1/0;get falls(){return this.setup.controller==="off"||this.analysed?.stable===!1}anew(e){this.fresh=!0,e(),this.fresh&&this.traces.begin(1/0)}acted(e){this.sent?.what==="stood"&&(this.rest={wheel:0,from:e}),this.fresh?this.traces.begin(e):this.sent&&(this.sent.t=e),this.fresh=!1,this.sent=null}get settled(){return this.snapshot!==null&&!this.waiting&&this.changed?.busy===!1}note(e,t){const{hand:n}=this.last,{marks:s}=this.traces,o=n.on;["Change","Drag","Strike","Steer","StandUp"].includes(e.kind)&&(this.rest=null),this.last.note(e,t),e.kind==="Strike"?s.push({t,what:e.what,size:e.size}):e.kind==="StandUp"?s.push({t,what:e.pitch?"tilt":"stood",size:e.pitch}):n.on&&!o?s.push({t,what:"hand",size:0}):o&&s.at(-1)?.what==="hand"&&(s.at(-1).size=n.impulse),(e.kind==="Strike"||e.kind==="StandUp"||n.on&&!o)&&(this.sent=s.at(-1)??null)}listen(e){this.listeners.push(e)}change(e){e.robot!==void 0&&e.robot!==this.setup.robot&&this.last.name(null),this.expect(e),this.corrected(),this.ceiling=null,this.asked.push(bd(this.setup)),this.send({kind:"Change",setup:this.setup})}push(e){(e.kind==="Strike"||e.force!==0)&&this.snapshot?.x[0][8]?this.hear({kind:"Notice",level:"info",text:"",key:"lies",job:""}):this.send(e)}expect(e){const t=qr(this.setup);this.setup={...this.setup,...e},qr(this.setup)!==t&&(this.waiting=!0,this.forget())}forget(){this.analysed=null,this.certified=null,this.trying=null,this.lit=Xp;for(const e of this.listeners)e(this.lit)}alone({t:e,x:[t]}){if(this.rest===void 0&&(this.rest=e<KA&&!this.recorded?{wheel:t[2],from:e}:null),!this.rest||e<=this.rest.from||this.falls||Math.abs(t[2]-this.rest.wheel)<_d)return;const{rest:n,traces:s}=this,o=s.t.findIndex((r,a)=>r>n.from&&Math.abs(s.x[0][2][a]-n.wheel)>=_d);s.marks.push({t:s.t[o]??e,what:"self",size:0}),this.rest=null}recall(e){const t=this.traces.t.at(-1);t!==void 0&&e.t-t>=qA&&(this.missing=Math.min(this.missing,t)),!(this.missing===1/0||performance.now()-this.recalled<gd)&&(this.recalled=performance.now(),this.send({kind:"Recall",since:this.missing}),this.missing=1/0)}hear(e){switch(e.kind){case"Snapshot":this.snapshot=e,this.sent?.what==="hand"&&e.f[0]&&([this.sent.t,this.sent]=[e.t,null]),e.back||(this.lain=e.x.every(t=>t[8])?this.lain??e.t:null),e.back||(this.recall(e),this.traces.add(e),this.alone(e));break;case"Welcome":this.traces.from=-1/0,this.asked=[],this.jobs.clear(),this.role=e.role,this.session=e.session,this.files=e.files,this.invite=e.invite;break;case"Catalogue":this.catalogue=e;break;case"Changed":this.changedTo(e);break;case"Analysed":if(this.waiting)return;this.analysed=e;break;case"Equations":this.equations=e;break;case"Light":if(this.waiting)return;this.lit=e,this.trying=null;break;case"Progress":e.job==="light"&&e.runs&&!this.waiting&&(this.trying=e),e.job!=="light"&&e.job!=="design"&&(e.fraction<1?this.jobs.add(e.job):this.jobs.delete(e.job));break;case"Acted":this.acted(e.t);break;case"Board":this.board=e;break;case"JobResult":this.found=e,e.job==="certify"&&e.rows.length&&(this.certified=e);break;case"Notice":e.key==="tooMany"&&this.changed&&(this.asked=[],this.hear(this.changed));break;case"History":this.traces.fill(e.t,e.rows);break}for(const t of this.listeners)t(e)}outdated(e){const t=this.asked.indexOf(bd(e));return this.asked=t<0?[]:this.asked.slice(t+1),this.asked.length>0}changedTo(e){const t=this.changed?.bodies.join()===e.bodies.join(),n=this.changed,s=n!==null&&qr(n.setup)!==qr(e.setup);this.changed=e;const o=this.outdated(e.setup);this.traces.other||=n!==null&&(vd(n.setup)!==vd(e.setup)||n.busy&&!e.busy),s&&!this.waiting&&this.forget(),o||([this.waiting,this.setup]=[!1,e.setup]),t||this.traces.reset(e.bodies.length)}}const R=new JA,QA=13,eR=10.5,bc=["stood","self"],tR=5,nR=2;function iR({what:i,size:e}){const t=fn(e||i!=="hand"?`mark_${i}`:"mark_held"),n=t.replace(/(?<=\{size\}).*/,"");return[...new Set([t,n])].map(s=>s.replace("{size}",at(Math.abs(e),2)))}class sR{root=D("div",{className:"marks"});shown="";draw(e,t){const{ctx:n,bbox:{left:s,top:o,width:r,height:a}}=e,l=t*devicePixelRatio,{push:c,soft:h}=ps();let u=s+r+16*l;const d=[],p=R.traces.marks.map(g=>({mark:g,x:e.valToPos(g.t,"x",!0)})).filter(({x:g})=>g>=s&&g<=s+r);n.save(),n.lineWidth=l,n.setLineDash([3*l,3*l]),n.font=`${eR*l}px system-ui, sans-serif`;for(const{mark:g,x:_}of p.reverse()){n.strokeStyle=bc.includes(g.what)?h:c,n.beginPath(),n.moveTo(_,o),n.lineTo(_,o+a),n.stroke();const m=nR*l,f=Math.min(...p.map(S=>S.x).filter(S=>S>_+m))-m,M=Math.max(s,...p.map(S=>S.x).filter(S=>S<_-m).map(S=>S+m));for(const S of iR(g)){const b=n.measureText(S).width+3*l,F=Math.min(_,u-b,f-b);if(!(F<M||F+b<_)){d.push([S,g.what,F/devicePixelRatio]),u=F-tR*l;break}}}n.restore(),this.label(d)}label(e){const t=JSON.stringify(e.map(([n,s])=>[n,s]));t!==this.shown&&this.root.replaceChildren(...e.map(([n,s])=>D("span",{className:`event ${bc.includes(s)?"quiet":""}`},n))),this.shown=t,e.forEach(([,,n],s)=>this.root.children[s].style.left=`${n.toFixed(1)}px`)}}const oR="http://www.w3.org/2000/svg",rr=420,qt={left:58,right:10,top:8,bottom:34};function Mr(i){const e=i.square?rr*.82:190,t=jn("svg",{viewBox:`0 0 ${rr} ${e}`,role:"img","aria-label":i.title,class:"drawing"}),n=_=>i.logX?Math.log10(_):_,[s,o]=[n(i.x[0]),n(i.x[1])],[r,a]=[rr-qt.left-qt.right,e-qt.top-qt.bottom],l=_=>qt.left+(n(_)-s)/(o-s)*r,c=_=>qt.top+(1-(_-i.y[0])/(i.y[1]-i.y[0]))*a,h=ps(),u=`clip-${Math.random().toString(36).slice(2)}`,d=jn("clipPath",{id:u});d.append(jn("rect",{x:qt.left,y:qt.top,width:r,height:a})),t.append(d);for(const _ of i.logX?lR(i.x):Ua(i.x,6))t.append(jn("line",{x1:l(_),x2:l(_),y1:qt.top,y2:qt.top+a,stroke:h.grid})),t.append(Xr(yd(_),l(_),qt.top+a+14,"middle",h.soft));for(const _ of Ua(i.y,5))t.append(jn("line",{x1:qt.left,x2:rr-qt.right,y1:c(_),y2:c(_),stroke:h.grid})),t.append(Xr(yd(_),qt.left-6,c(_)+4,"end",h.soft));t.append(Xr(i.xLabel,qt.left+r/2,e-4,"middle",h.soft));const p=Xr(i.yLabel,0,0,"middle",h.soft);p.setAttribute("transform",`translate(9 ${qt.top+a/2}) rotate(-90)`),t.append(p);const g=jn("g",{"clip-path":`url(#${u})`});t.append(g),i.circle&&g.append(jn("ellipse",{cx:l(0),cy:c(0),rx:l(1)-l(0),ry:c(0)-c(1),fill:"none",stroke:h.soft,"stroke-dasharray":"4 3"}));for(const _ of i.marks??[]){const m=_.y===void 0?{x1:l(_.x??0),x2:l(_.x??0),y1:qt.top,y2:qt.top+a}:{y1:c(_.y),y2:c(_.y),x1:qt.left,x2:rr-qt.right};g.append(jn("line",{...m,stroke:h.push,"stroke-width":1.2,"stroke-dasharray":"5 3"}))}for(const _ of i.lines??[])g.append(rR(_,l,c));for(const _ of i.points??[])g.append(aR(_.cross??!1,l(_.x),c(_.y),_.colour));return t}function jn(i,e={}){const t=document.createElementNS(oR,i);for(const[n,s]of Object.entries(e))t.setAttribute(n,String(s));return t}function Xr(i,e,t,n,s){const o=jn("text",{x:e,y:t,"text-anchor":n,fill:s,"font-size":11.5});return o.textContent=i,o}function rR(i,e,t){let n="",s=!1;return i.x.forEach((o,r)=>{const a=i.y[r],l=Number.isFinite(o)&&Number.isFinite(a);l&&(n+=`${s?"L":"M"}${e(o).toFixed(1)} ${t(a).toFixed(1)}`),s=l}),jn("path",{d:n,fill:"none",stroke:i.colour,"stroke-width":1.8,"stroke-dasharray":(i.dash??[]).join(" "),"stroke-linejoin":"round"})}function aR(i,e,t,n){if(!i)return jn("circle",{cx:e,cy:t,r:4,fill:n});const s=4.5;return jn("path",{d:`M${e-s} ${t-s}L${e+s} ${t+s}M${e-s} ${t+s}L${e+s} ${t-s}`,stroke:n,"stroke-width":1.8})}function Ua([i,e],t){const n=(e-i)/t,s=10**Math.floor(Math.log10(n)),o=[1,2,5,10].map(a=>a*s).find(a=>a>=n)??n,r=[];for(let a=Math.ceil(i/o)*o;a<=e+o*1e-6;a+=o)r.push(Math.abs(a)<o*1e-6?0:a);return r}function lR([i,e]){const t=[];for(let n=Math.ceil(Math.log10(i));10**n<=e;n+=1)t.push(10**n);return t}function yd(i){return $i(String(+i.toPrecision(6)).replace("-","−"))}function jp(i){try{const e=i();return e.getItem(""),e}catch{const e=new Map;return{getItem:t=>e.get(t)??null,setItem:(t,n)=>void e.set(t,n),removeItem:t=>void e.delete(t)}}}const os=jp(()=>localStorage),Fi=jp(()=>sessionStorage);class yc{root;plot;marks=new sR;extent=[NaN,NaN];constructor(e,t,n,s,o,r=()=>1/0){const a=ps(),l=parseFloat(getComputedStyle(document.documentElement).fontSize)/16,c={stroke:a.soft,grid:{stroke:a.grid,width:1},ticks:{show:!1},font:`${11*l}px system-ui, sans-serif`},h=D("div",{className:"plot","aria-hidden":"true"},this.marks.root);h.style.setProperty("--height",`${s/16}rem`),this.root=D("figure",{className:"strip",role:"group","aria-label":`${e} [${t}]`},D("figcaption",{},D("b",{},e),D("span",{},t)),h),this.plot=new bn({width:300,height:s,padding:[QA*l,18*l,0,0],cursor:{show:!1},legend:{show:!1},hooks:{draw:[u=>this.marks.draw(u,l)]},scales:{x:{time:!1},y:{range:()=>Yp(Math.max(this.extent[0],-r()),Math.min(this.extent[1],r()),o)}},axes:[{...c,size:20*l,values:(u,d)=>d.map(p=>p<0?"":$i(`${+p.toFixed(2)} s`)),space:46*l},{...c,size:46*l,splits:(u,d,p,g)=>hR(p,g,u.bbox.height/devicePixelRatio/(18*l)),values:(u,d)=>d.map(p=>$i(String(+p.toPrecision(4)).replace("-","−")))}],series:[{},...n.map(u=>({label:u.label,stroke:u.colour,width:(u.width??1.6)*l,dash:u.dash,points:{show:!1},spanGaps:!1,gaps:(d,p,g,_,m)=>[...m,...cR(d)].sort(([f],[M])=>f-M)}))]},[[],...n.map(()=>[])],h),new ResizeObserver(()=>this.fit(h)).observe(h)}fit(e){e.clientWidth>40&&this.plot.setSize({width:e.clientWidth,height:e.clientHeight})}show(e,t,n,s,o=t){const r=o.flat().filter(Number.isFinite);this.extent=r.length?[Math.min(...r),Math.max(...r)]:[NaN,NaN],this.plot.batch(()=>{this.plot.setData([e,...t],!1),this.plot.setScale("x",{min:n,max:s})})}}function cR(i){const{left:e,width:t}=i.bbox,n=2*devicePixelRatio;return R.traces.breaks.map(s=>s.map(o=>i.valToPos(o,"x",!0))).map(([s,o])=>[s-n/2,Math.max(o,s+n)]).filter(([s,o])=>s>e&&o<e+t)}function hR(i,e,t){let n=Math.max(1,Math.floor(t)),s=Ua([i,e],n);for(;s.length<2&&n<12;)s=Ua([i,e],n+=1);return s}function Yp(i,e,t){if(!Number.isFinite(i)||!Number.isFinite(e))return[-t,t];const n=(i+e)/2,s=Math.max((e-i)/2*1.1,t);return[n-s,n+s]}const wl=[0,2],uR=[.05,.3,.5,1,.05,.2],Gs=matchMedia("(max-width: 40rem), (max-width: 62rem) and (max-height: 32rem)"),El=matchMedia("(max-width: 40rem)"),xd=matchMedia("(min-width: 40.01rem)");class dR{constructor(e){this.seconds=e;for(const t of[Gs,xd])t.addEventListener("change",()=>this.build())}root=D("section",{className:"charts"});strips=[];legend=D("div",{className:"legend"});slot=D("div",{className:"slot"});large=null;build(){this.root.setAttribute("aria-label",N("charts"));const e=R.changed?.bodies??[],t=e.map(u=>({label:fn(u),colour:cs(u),dash:Ih(u,e)})),n=os.getItem("curves")==="all";El.matches||(this.large=null),this.strips=qs.map((u,d)=>n||wl.includes(d)?new yc(`${Vs[d]}  ${fn(u)}`,Uh[d],t,104,uR[d],d?void 0:()=>R.ceiling??1/0):null),$e(this.legend,...e.map(u=>Kp(u)));const s=Gs.matches?xd.matches?wl.slice(0,1):wl:[],o=this.strips.filter((u,d)=>s.includes(d)).map(u=>u?.root),r=this.strips.map(u=>u?.root).filter(u=>!o.includes(u));this.strips.forEach((u,d)=>u&&this.enlargeable(u.root,d));const a=N(n?"fewerCurves":"moreCurves"),l=st(El.matches?N(n?"fewer":"more"):a,()=>n?this.shown("first"):this.more(),{className:"quiet","aria-label":a,"aria-expanded":String(n),"data-key":"curves"}),c=u=>u.some(Boolean)?D("div",{className:`strips${n?" all":""}`},...u):null,h=D("div",{className:"above"},this.legend,l);$e(this.slot,...o.length?[h,c(o)]:[]),$e(this.root,o.length?null:h,c(r)),this.root.hidden=!this.root.childElementCount}more(){this.shown("all"),Gs.matches&&this.root.scrollIntoView()}shown(e){os.setItem("curves",e),Hs(()=>this.build())}enlargeable(e,t){const n=D("button",{type:"button",className:"enlarge","data-key":`enlarge-${t}`},D("span",{"aria-hidden":"true"},"⤢"),D("span",{className:"hidden"},N("large",{what:fn(qs[t])})));e.classList.toggle("large",this.large===t),n.setAttribute("aria-expanded",String(this.large===t)),e.querySelector("figcaption")?.append(n),e.addEventListener("click",()=>{El.matches&&(this.large=this.large===t?null:t,Hs(()=>this.build()))})}draw(){const{t:e,x:t}=R.traces;if(!e.length||t.length!==R.changed?.bodies.length)return;const[n,s]=[this.seconds(),e.at(-1)],o=R.lain===null?s:Math.min(s,R.lain+.1*n),r=R.snapshot?.back?R.snapshot.t:Math.max(o,e[0]+n),a=r-n;let l=e.length;for(;l>0&&e[l-1]>=a;)l-=1;l=Math.max(0,l-1);const c=e.slice(l),h=R.traces.marks.findLast(_=>["stood","tilt"].includes(_.what)&&_.t<=r)?.t??-1/0,u=c.findIndex(_=>_>=Math.max(a,h)),d=R.snapshot?.x.map(_=>_[8]===1)??[],p=t.map((_,m)=>d.every(Boolean)||!d[m]),g=this.clipped(c,t[0]&&t.map(_=>_[0].slice(l)));this.strips.forEach((_,m)=>{const f=t.map(b=>b[m].slice(l)),M=u<0?f:f.filter((b,F)=>p[F]).map(b=>b.slice(u)),S=g&&m===0&&m===this.large?g:[a,r];_?.show(c,f,...S,M)})}clipped(e,t){const{ceiling:n}=R;if(n===null||!e.length)return null;const s=Math.max(...t.map(o=>o.findIndex(r=>Math.abs(r)>n)+1||1/0));return s<=e.length&&s>1?[e[0],e[s-1]]:null}}function Kp(i){const e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("width","28"),e.setAttribute("height","10"),e.setAttribute("aria-hidden","true");const t=document.createElementNS("http://www.w3.org/2000/svg","line"),n={x1:"0",x2:"28",y1:"5",y2:"5",stroke:cs(i),"stroke-width":"2.5","stroke-dasharray":Ih(i,R.changed?.bodies??[]).join(" ")};for(const[a,l]of Object.entries(n))t.setAttribute(a,l);e.append(t);const o={twin:N("twinNote"),nonlinear:N("nonlinearNote"),linear:N("linearNote"),published:N("publishedNote"),calibrated:N("calibratedNote")}[i]??"",r=i===R.changed?.bodies[0];return D("span",{className:"key",title:o},e,r?N("robotIs",{body:fn(i)}):fn(i))}const fR=60,pR=5e3;class mR{since=-1;lean=0;actions=[];begin(e,t,n){[this.since,this.lean]=[e,t],this.actions=n.speed||n.rate?[[0,{kind:"Steer",...n}]]:[]}stop(){this.since=-1}note(e,t){this.since>=0&&this.actions.length<pR&&this.actions.push([Ro(t-this.since),e])}handIn(e,t,n,s,o){const r=Ro(s-this.since);if(this.since<0||!(r>0&&r<=fR)||!e.trim())return null;const a={kind:"upright hand-in",version:1,student:e.trim(),setup:t,step:n,lean:this.lean,seconds:r,actions:this.actions,claimed:o};return Fa({...a,seal:vR(Fa(a))})}}function Ro(i){return Number(i.toFixed(6))}const gR=["version","seed"];function Fa(i,e=""){return typeof i=="number"?gR.includes(e)?String(i):_R(i):Array.isArray(i)?`[${i.map(n=>Fa(n)).join(", ")}]`:i===null||typeof i!="object"?JSON.stringify(i):`{${Object.entries(i).sort(([n],[s])=>n<s?-1:1).map(([n,s])=>`${JSON.stringify(n)}: ${Fa(s,n)}`).join(", ")}}`}function _R(i){const[e,t]=i.toExponential().split("e").map((s,o)=>o?Number(s):s);if(i&&(t<-4||t>15))return`${e}e${t<0?"-":"+"}${String(Math.abs(t)).padStart(2,"0")}`;const n=Object.is(i,-0)?"-0":String(i);return n.includes(".")?n:`${n}.0`}function vR(i){const e=new TextEncoder().encode(i),t=Math.ceil((e.length+9)/64)*64,n=new Uint8Array(t);n.set(e),n[e.length]=128;const s=new DataView(n.buffer);s.setUint32(t-8,Math.floor(e.length/2**29)),s.setUint32(t-4,e.length<<3);const o=Md.slice(0,8).map(c=>Sd(Math.sqrt(c))),r=Md.map(c=>Sd(Math.cbrt(c))),a=new Int32Array(64),l=(c,h)=>c>>>h|c<<32-h;for(let c=0;c<t;c+=64){for(let M=0;M<16;M+=1)a[M]=s.getInt32(c+4*M);for(let M=16;M<64;M+=1){const[S,b]=[a[M-15],a[M-2]];a[M]=a[M-16]+(l(S,7)^l(S,18)^S>>>3)+a[M-7]+(l(b,17)^l(b,19)^b>>>10)}let[h,u,d,p,g,_,m,f]=o;for(let M=0;M<64;M+=1){const S=f+(l(g,6)^l(g,11)^l(g,25))+(g&_^~g&m)+r[M]+a[M]|0,b=(l(h,2)^l(h,13)^l(h,22))+(h&u^h&d^u&d)|0;[h,u,d,p,g,_,m,f]=[S+b|0,h,u,d,p+S|0,g,_,m]}[h,u,d,p,g,_,m,f].forEach((M,S)=>o[S]=o[S]+M|0)}return o.map(c=>(c>>>0).toString(16).padStart(8,"0")).join("")}const Md=Array.from({length:312},(i,e)=>e).filter(i=>i>1&&![2,3,5,7,11,13,17].some(e=>i%e===0&&i>e));function Sd(i){return(i-Math.floor(i))*2**32|0}const wd=1e-9,bR=1-1e-9,[yR,xR]=[.3,.001],[MR,SR]=[3e3,160],xa=(i,e)=>Array.from({length:i},()=>new Float64Array(e));function xc(i,e){const t=xa(i.length,e[0].length);for(let n=0;n<i.length;n+=1){const[s,o]=[i[n],t[n]];for(let r=0;r<s.length;r+=1){const[a,l]=[s[r],e[r]];if(a)for(let c=0;c<o.length;c+=1)o[c]+=a*l[c]}}return t}const Zp=i=>Math.max(...i.map(e=>e.reduce((t,n)=>t+Math.abs(n),0)));function Ed({A:i,B:e},t){const n=[...i.map((a,l)=>Float64Array.from([...a,...e[l]],c=>c*t)),...xa(2,8)],s=Math.max(0,Math.ceil(Math.log2(Zp(n)+1e-300))+2);let[o,r]=[xa(8,8),xa(8,8)];for(let a=0;a<8;a+=1)r[a][a]=1;for(let a=1;a<20;a+=1)o=o.map((l,c)=>l.map((h,u)=>h+r[c][u])),r=xc(r,n).map(l=>l.map(c=>c/a/2**s));for(let a=0;a<s;a+=1)o=xc(o,o);return o.slice(0,6)}function Tl(i,e){const t=Math.floor(i/e+wd),n=i-t*e;return[t,n>wd*e?n:0]}function Td(i,e,t,n=0,s=!1){const o=i.period,[r,a]=Tl(i.dead+n,o),l=Tl(i.dead,o)[0],c=S=>{const[b,F]=[Ed(i,Math.min(S,a)),Ed(i,Math.max(S-a,0))],L=(A,U,E)=>A.map(x=>x.reduce((C,V,O)=>C+V*(O<6?U[O]:E[O-6]),0));return(A,U,E)=>L(F,L(b,A,E),U)},h=i.delays.map(S=>{const[b,F]=Tl(S,o);return F?{count:b+1,enters:c(o-F)}:{count:b,enters:null}}),u=c(o),[d,p]=[r+(a?1:0),new Float64Array(6)],g=6+h.reduce((S,b)=>S+b.count,0),_=g+2*d,m=_+e.start.length+2*l,f=S=>{const b=new Float64Array(m),F=(X,Y)=>i.C[Y].reduce((ee,ae,ce)=>ee+ae*X[ce],0);let L=6;const A=Float64Array.from(h,({count:X},Y)=>(L+=X,X?S[L-1]:F(S,Y))),[U,E]=[S.slice(_,_+e.start.length),new Float64Array(8)];e.command(U,A,p,E,t);const x=s?(E[0]+E[1])/2:0,C=[E[0]-x,E[1]-x],V=X=>X?[...S.slice(g+2*X-2,g+2*X)]:C,[O,q]=[V(r),a?V(r+1):[0,0]];b.set(u(S,O,q)),L=6,h.forEach(({count:X,enters:Y},ee)=>{X&&(b.set(S.subarray(L,L+X-1),L+1),b[L]=F(Y?Y(S,O,q):S,ee)),L+=X}),d&&b.set([...C,...S.subarray(g,_-2)],g);const $=_+e.start.length;return e.update(U,A,p,E,t,l?S.slice(m-2):E.slice(0,2)),b.set(U,_),l&&b.set([...E.subarray(0,2),...S.subarray($,m-2)],$),b},M=Array.from({length:m},(S,b)=>f(new Float64Array(m).fill(1,b,b+1)));return Array.from({length:m},(S,b)=>Float64Array.from(M,F=>F[b]))}function Ad(i){let[e,t]=[i,0];for(let n=0;n<34;n+=1){const s=Zp(e);if(t+=Math.log(s),!(s>0)||t<-1)return!0;if(t>60)return!1;e=e.map(o=>o.map(r=>r/s)),e=xc(e,e),t*=2}return!1}function Rd(i){const e=i.length,t=i.map(a=>Float64Array.from(a));for(let a=1;a<e-1;a+=1){let l=a;for(let c=a+1;c<e;c+=1)Math.abs(t[c][a-1])>Math.abs(t[l][a-1])&&(l=c);if(t[l][a-1]){[t[a],t[l]]=[t[l],t[a]];for(const c of t)[c[a],c[l]]=[c[l],c[a]];for(let c=a+1;c<e;c+=1){const h=t[c][a-1]/t[a][a-1];if(h){for(let u=0;u<e;u+=1)t[c][u]-=h*t[a][u];for(const u of t)u[a]+=h*u[c]}}}}const n=i.map(()=>new Float64Array(e)),s=[];let[o,r]=[e-1,0];for(;o>=0;){let a=o;const l=u=>Math.hypot(t[u][u-1],n[u][u-1])<=Number.EPSILON*(Math.hypot(t[u][u],n[u][u])+Math.hypot(t[u-1][u-1],n[u-1][u-1]));for(;a>0&&!l(a);)a-=1;if(a===o){s.push([t[o][o],n[o][o]]),[o,r]=[o-1,0];continue}const[c,h]=r%11===10?[Math.abs(t[o][o-1])+t[o][o],n[o][o]]:wR(t,n,o);if(ER(t,n,a,o,c,h),r+=1,r>300)return s}return s}function wR(i,e,t){const n=(p,g)=>[i[p][g],e[p][g]],[s,o,r,a]=[n(t-1,t-1),n(t-1,t),n(t,t-1),n(t,t)],l=[(s[0]-a[0])/2,(s[1]-a[1])/2],c=AR(Cd(Al(l,l),Al(o,r))),h=l[0]*c[0]+l[1]*c[1]<0?-1:1,u=Cd(l,[h*c[0],h*c[1]]),d=u[0]||u[1]?TR(Al(o,r),u):u;return[a[0]-d[0],a[1]-d[1]]}function ER(i,e,t,n,s,o){for(let a=t;a<=n;a+=1)[i[a][a],e[a][a]]=[i[a][a]-s,e[a][a]-o];const r=[];for(let a=t;a<n;a+=1){const[l,c,h,u]=[i[a][a],e[a][a],i[a+1][a],e[a+1][a]],d=Math.hypot(l,c,h,u)||1,[p,g,_,m]=[l/d,c/d,h/d,u/d];r.push([p,g,_,m]);for(let f=a;f<=n;f+=1){const[M,S,b,F]=[i[a][f],e[a][f],i[a+1][f],e[a+1][f]];i[a][f]=p*M+g*S+_*b+m*F,e[a][f]=p*S-g*M+_*F-m*b,i[a+1][f]=p*b-g*F-_*M+m*S,e[a+1][f]=p*F+g*b-_*S-m*M}}r.forEach(([a,l,c,h],u)=>{const d=t+u;for(let p=t;p<=Math.min(d+1,n);p+=1){const[g,_,m,f]=[i[p][d],e[p][d],i[p][d+1],e[p][d+1]];i[p][d]=a*g-l*_+c*m-h*f,e[p][d]=a*_+l*g+c*f+h*m,i[p][d+1]=a*m+l*f-c*g-h*_,e[p][d+1]=a*f-l*m-c*_+h*g}});for(let a=t;a<=n;a+=1)[i[a][a],e[a][a]]=[i[a][a]+s,e[a][a]+o]}const Cd=(i,e)=>[i[0]+e[0],i[1]+e[1]],Al=(i,e)=>[i[0]*e[0]-i[1]*e[1],i[0]*e[1]+i[1]*e[0]],TR=(i,e)=>[(i[0]*e[0]+i[1]*e[1])/(e[0]**2+e[1]**2),(i[1]*e[0]-i[0]*e[1])/(e[0]**2+e[1]**2)];function AR([i,e]){const t=Math.hypot(i,e);return[Math.sqrt(Math.max(t+i,0)/2),(e<0?-1:1)*Math.sqrt(Math.max(t-i,0)/2)]}function Pd(i,e,t){return e.slice(1).flatMap((n,s)=>{if(t[s]<0==t[s+1]<0)return[];let[o,r]=[e[s],e[s+1]];for(let a=0;a<60;a+=1){const l=(o+r)/2;i(l)<0==t[s]<0?o=l:r=l}return[(o+r)/2]})}const Jp=(i,e,t)=>Array.from({length:t},(n,s)=>i*(e/i)**(s/(t-1))),Qp=i=>Jp(.05,Math.PI/i,SR).filter((e,t)=>t%2===0);function RR(i,e){let[t,n]=[0,0];for(;i(n);){if(t>e)return 1/0;[t,n]=[n,n+xR]}for(let s=0;n&&s<12;s+=1){const o=(t+n)/2;i(o)?t=o:n=o}return t}const Ld=i=>Number.isFinite(i)?i:null;function Nd(i){if(!i.stable)return{...i,words:`The loop is unstable: its largest pole is at |z| = ${Math.hypot(...i.poles[0]).toFixed(4)}.`};const e=o=>`${Math.round(100*o)} %`,t=i.gain_low>0?`as weak as ${e(i.gain_low)}`:"however weak",n=(i.gain_high??1/0)<1e3?`as strong as ${e(i.gain_high??0)}`:"however strong",s=i.delay===null?"any delay":`${Math.round(1e3*i.delay)} ms more delay`;return{...i,words:`both motors: survives ${s}, and ${t} or ${n} of its gain.`}}function CR(i,e,t){const[n,s]=[!1,!0].map(A=>Td(i,e,t,0,A)),o=Rd(n).sort((A,U)=>Math.hypot(...U)-Math.hypot(...A)),r=Rd(s),a=A=>{const U=[Math.cos(A*i.period),Math.sin(A*i.period)];let[E,x]=[1,0];for(let C=0;C<o.length;C+=1){const[V,O,q,$]=[U[0]-o[C][0],U[1]-o[C][1],U[0]-r[C][0],U[1]-r[C][1]],[X,Y,ee]=[q*q+$*$,V*q+O*$,O*q-V*$];[E,x]=[(E*Y-x*ee)/X,(E*ee+x*Y)/X]}return[E-1,x]},l=Math.PI/i.period,c=Qp(i.period),h=c.map(a),u={stable:Math.hypot(...o[0])<bR,poles:o,gain_low:1,gain_high:1,phase:0,delay:0,L:[c,h.map(([A])=>A),h.map(([,A])=>A)]};if(!u.stable)return Nd(u);const d=Array.from({length:300},(A,U)=>(U+1)*l/300),p=[...Jp(Math.min(.001,l/1e6),l,MR),...d].sort((A,U)=>A-U),g=p.map(a),m=[0,l,...Pd(A=>a(A)[1],p,g.map(([,A])=>A))].map(A=>a(A)[0]).filter(A=>A<0&&A>-1e6).map(A=>-1/A).sort((A,U)=>A-U),f=A=>A.find(U=>!Ad(s.map((E,x)=>E.map((C,V)=>C+(U+(U-1)/1e3)*(n[x][V]-C))))),M=([A,U])=>A*A+U*U-1,S=Pd(A=>M(a(A)),p,g.map(M)),b=S.map(A=>{const[U,E]=a(A);return(Math.atan2(E,U)+3*Math.PI)%(2*Math.PI)}),F=b.map((A,U)=>A/S[U]),L=RR(A=>Ad(Td(i,e,t,A)),Math.min(yR,...F));return Nd({...u,gain_low:f(m.filter(A=>A<1).reverse())??0,gain_high:f(m.filter(A=>A>1))??null,phase:Ld(Math.min(...b.map(A=>Math.min(A,2*Math.PI-A)))),delay:Ld(Math.min(L,...F))})}const[PR,LR,NR,DR]=[.05,.4,1,.5];class Oh{best=0;run=0;effort=0;given=0;impulse=0;lasted=0;calm=0;before=0;push(){this.given||([this.impulse,this.lasted,this.before]=[0,0,this.effort]),this.given+=1,this.calm=0}exchanged(){this.given+=this.given?1:0,this.impulse=0}anew(e){return Object.assign(new Oh,{best:this.best,given:e?1:0})}watch(e,t,n,s,o,r){if(this.effort+=(o[0]**2+o[1]**2)*e,t)this.impulse+=Math.abs(t)*e,this.lasted+=e,this.calm=0;else if(this.given&&(this.calm=Math.abs(n)<PR&&Math.abs(s)<LR?this.calm+e:0,r||this.calm>=NR))return this.ended(r);return null}ended(e){const t=this.given===1;return this.given=0,!this.impulse||this.lasted>DR&&!e?null:(t&&!e&&(this.run=Math.max(this.run,this.impulse)),this.best=Math.max(this.best,this.run),{kind:"Recovered",impulse:this.impulse,effort:this.effort-this.before,best:this.best,fell:e,single:t})}}function IR(i){const e=Math.round(i);return Math.abs(i%1)===.5&&e%2?e-1:e}const kR=(i,e,t,n,s,o,r,a,l)=>{const c=Math.abs(i),h=n<c?i:0,u=Math.abs(e),d=n<u?e:0,p=Math.abs(h),g=p<r?p:r,_=Math.abs(d),m=_<r?_:r,f=g+m,M=a*f,S=r-M,b=t<S?t:S,F=-b,L=b<h?b:h,A=h<F?F:L,U=-s,E=U<0?s:1,x=A/E,V=Math.trunc(x)*E,O=U<0?V:A,q=b<d?b:d,$=d<F?F:q,X=$/E,ee=Math.trunc(X)*E,ae=U<0?ee:$,ce=-o,_e=o<O?o:O,be=O<ce?ce:_e,me=O-be,oe=ce<0?me:O,ue=o<ae?o:ae,ve=ae<ce?ce:ue,he=ae-ve,Ie=ce<0?he:ae,Be=p<_?_:p,ke=b<Be?1:0;l[0]=oe,l[1]=Ie,l[2]=S,l[3]=ke},UR=(i,e,t,n,s,o,r,a,l)=>{const c=Math.abs(i),h=n<c?i:0,u=Math.abs(e),d=n<u?e:0,p=Math.abs(h),g=p<r?p:r,_=Math.abs(d),m=_<r?_:r,f=g+m,M=a*f,S=r-M,b=-t,F=t<h?t:h,L=h<b?b:F,A=-s,U=A<0?s:1,E=L/U,C=Math.trunc(E)*U,V=A<0?C:L,O=t<d?t:d,q=d<b?b:O,$=q/U,Y=Math.trunc($)*U,ee=A<0?Y:q,ae=-o,ce=o<V?o:V,_e=V<ae?ae:ce,be=V-_e,me=ae<0?be:V,oe=o<ee?o:ee,ue=ee<ae?ae:oe,ve=ee-ue,he=ae<0?ve:ee,Ie=p<_?_:p,Be=t<Ie?1:0;l[0]=me,l[1]=he,l[2]=S,l[3]=Be},FR=(i,e,t,n,s)=>{const o=i*t,r=e*n;s[0]=o,s[1]=r},OR=(i,e,t,n)=>{const s=e-t,o=e+t,r=o<i?o:i,a=i<s?s:r;n[0]=a},zR=(i,e,t,n,{quantum:s,noise:o,bias_walk:r,range:a,gain:l,offset:c},h)=>{const u=r*n,d=e+u,_=l*i+c+d,m=o*t,f=_+m,M=-s,S=M<0?s:1,b=f/S,L=IR(b)*S,A=M<0?L:f,U=-a,E=a<A?a:A,x=A<U?U:E;h[0]=x,h[1]=d},BR=(i,e,{tilt:t,b1:n,b2:s,a1:o,a2:r},a)=>{const l=s*i,c=r*i,h=l+c,u=n*i,d=o*i,g=u+d+h,_=t*e,m=i+_;a[0]=m,a[1]=g,a[2]=h},HR=(i,e,t,n,{tilt:s,b0:o,b1:r,b2:a,a1:l,a2:c},h)=>{const d=o*i+t,p=r*i,g=l*d,m=p+g+n,f=a*i,M=c*d,S=f+M,b=s*e,F=d+b;h[0]=F,h[1]=m,h[2]=S},VR=(i,e,t,n,s,o,r,{time_constant:a,spell:l},c)=>{const h=s*e,u=o*t,d=h+u,p=r*a,g=d/p,_=n-g,m=l*_,f=i+m;c[0]=f},GR=1.4,WR=.8,Dd=1e-9,[$R,qR,XR,jR]=[0,2,4,6];function YR(i,e,t,n){let s=0,o=0;for(const r of i){const a=r.start-Dd<=e&&e<r.start+r.duration-Dd;s+=a?r.force:0,o+=(a?r.force:0)*r.height}n[0]=s,n[1]=s?o/s:0,n[2]=t}function Id(i,e){const[t,n,s,o]=[i>>>16,i&65535,e>>>16,e&65535],r=t*o+Math.floor(n*o/65536),a=n*s+r%65536;return t*s+Math.floor(r/65536)+Math.floor(a/65536)}function em([i,e,t,n],[s,o]){for(let r=0;r<10;r+=1)[i,e,t,n]=[(Id(3449720151,t)^e^s)>>>0,Math.imul(3449720151,t)>>>0,(Id(3528531795,i)^n^o)>>>0,Math.imul(3528531795,i)>>>0],s=s+2654435769>>>0,o=o+3144134277>>>0;return[i,e,t,n]}function KR(i,e,t,n){const s=em([i,0,0,e+(t>>2)],[n,0]),[o,r]=t&2?s.slice(2):s,a=Math.sqrt(-2*Math.log((o+.5)/2**32)),l=Math.PI*(r/2**31-1);return a*(t&1?Math.sin(l):Math.cos(l))}function ZR(i,e){const{from:t,every:n,b0:s,time_constant:o}=i,{x:r,ideal:a}=e,l=new Float64Array(3);return s!==void 0?(BR(r[1],r[5],i,l),()=>(e.steps&&HR(r[1],r[5],l[1],l[2],i,l),l[0])):o!==void 0?(l[0]=r[0],()=>{const[c,h]=[Math.cos(l[0]),Math.sin(l[0])];return e.steps&&e.steps%n===0&&VR(l[0],c,h,r[1],a[4],a[5],e.body.gravity,i,l),l[0]}):()=>t<0?e.voltage:a[t]}class JR{constructor(e,t,n){this.sensor=e,this.sense=ZR(e,n);const s=this.sense();this.seed=t,this.count=0,this.held=0,this.touch=s,this.line=new Float64Array(e.delay+1).fill(s),this.bias=e.bias*this.normal(XR),this.out=new Float64Array(2)}normal(e){return KR(this.count,e,this.sensor.kind,this.seed)}read(){const{play:e,delay:t,every:n}=this.sensor;let s=this.sense();return e&&(OR(this.touch,s,e,this.out),this.touch=s=this.out[0]),this.line[this.count%(t+1)]=s,this.count%n===0&&(this.held=this.fresh(this.line[(this.count+1)%(t+1)])),this.count+=1,this.held}fresh(e){const{bias_walk:t,noise:n,walks:s}=this.sensor,o=t&&this.count%s===0?this.normal(qR):0;return zR(e,this.bias,n?this.normal($R):0,o,this.sensor,this.out),this.bias=this.out[1],this.out[0]}}class QR{constructor(e,t,n,s){this.body=e,this.control=t,this.x=Float64Array.from(n),this.steps=0,this.z=Float64Array.from(t.law?.start??[]),this.before=Float64Array.from(this.z),this.y=new Float64Array(t.reads.length),this.u=new Float64Array(8),this.sent=new Float64Array(2),this.applied=new Float64Array(2),this.driven=new Float64Array(2),this.out=new Float64Array(4),this.w=new Float64Array(3),this.ideal=new Float64Array(7),this.stopped=!1,this.twist=0,e.motion.read(this.x,this.applied,this.w,this.ideal),this.ideal[6]=this.x[0],this.voltage=e.kit?.voltage??1/0,this.waiting=[],this.latest=[0,0],this.arrived=[0,0],this.seed=s,this.channels=(e.kit?.sensors??[]).map(o=>new JR(o,s,this)),this.values=new Float64Array(6+(e.kit?this.channels.length:7)),this.sense()}get t(){return this.steps*this.body.period}get fallen(){return Math.abs(this.x[0])>GR}sense(){this.values.set(this.x),this.body.kit||this.values.set(this.ideal,6),this.channels.forEach((e,t)=>this.values[6+t]=e.read())}step(e,t){const{law:n,reads:s,stride:o,gains:r=[]}=this.control;this.before.set(this.z);for(let a=0;a<s.length;a+=1)this.y[a]=this.values[s[a]];n?.command(this.z,this.y,e,this.u,r),this.stopped||=Math.abs(this.x[0])>WR,this.stopped?this.sent.fill(0):this.sent.set(this.u.subarray(0,2));for(let a=0;a<o;a+=1)t(this.t,this.w),this.move();n?.update(this.z,this.y,e,this.u,r,this.applied)}move(){const{motion:e,kit:t}=this.body;t?this.drive(t):this.applied.set(this.sent),FR(this.applied[0],this.applied[1],t?.left??1,t?.right??1,this.driven),this.driven[0]+=this.twist,this.driven[1]-=this.twist,e.step(this.x,this.driven,this.w,this.ideal),this.ideal[6]=this.x[0],this.steps+=1,this.sense()}drive(e){const[t,n]=this.delayed(e),[s,o]=[e.limit??1/0,e.voltage??1/0];(e.volts?kR:UR)(t,n,s,e.dead_zone,e.quantum,e.drop,o,e.sag,this.out),[this.applied[0],this.applied[1],this.voltage]=this.out}delayed(e){const[t,n]=this.sent;if(t!==this.latest[0]||n!==this.latest[1]){const[s]=em([this.steps,0,0,jR],[this.seed,0]),o=Math.floor(s*(e.jitter+1)/2**32);this.waiting.push([this.steps+e.delay+o,t,n]),this.latest=[t,n]}for(;this.waiting.length&&this.waiting[0][0]<=this.steps;)this.arrived=this.waiting.splice(0,1)[0].slice(1);return this.arrived}}function eC(i){const e=new Float64Array(6);let t=0;const n=(s,o,r,a)=>{const l=i.turn*s[4],[c,h]=[Math.cos(s[0]),Math.sin(s[0])],u=i.radius*t+i.gravity*Math.sin(r[2])*Math.cos(s[4]),d=i.gravity*Math.cos(r[2]);a.set([s[2]-l-s[0],s[2]+l-s[0],s[1],s[4],u*c-d*h,u*h+d*c])};return{step(s,o,r,a){const l=[r[0],r[0]*r[1],r[2]];for(let c=0;c<6;c+=1){let h=0;for(let u=0;u<6;u+=1)h+=i.A[c][u]*s[u];e[c]=h+i.B[c][0]*o[0]+i.B[c][1]*o[1]+i.E[c][0]*l[0]+i.E[c][1]*l[1]+i.E[c][2]*l[2]}t=(e[3]-s[3])/i.period,s.set(e),n(s,o,r,a)},read:n}}const Yt=globalThis.uprightExport??null,Oa=["nonlinear","linear"],Ma="off",tC=200,nC=.02,kd=.3,iC=3,sC=1.5,oC=60,Ud=.02,rC=2;function tm({facts:i}){const e=Object.entries(i.robots).map(([n,{controllers:s,laden:o}])=>[n,{controllers:[...Object.keys(s),Ma],load:o?.look??null}]),t=Gi.robot in i.robots?Gi.robot:i.catalogue.robots[0].name;return{usual:{...Gi,robot:t,bodies:[...Oa]},robots:Object.fromEntries(e),kits:[],parameters:[],bodies:Oa,keys:["gains","slope","noise","delay","seed","payload","payload_height","bodies"]}}class aC{loop;offset;constructor(e,t,n,s,o,r){this.offset=[0,0,o[2],0,o[4],0];const a=[o[0],o[1],0,o[3],0,o[5]];this.loop=new QR({motion:t,period:e.period,gravity:e.gravity,kit:n},s,a,r)}state(){const e=Array.from(this.loop.x,(t,n)=>t+this.offset[n]);return this.loop.fallen&&([e[0],e[1],e[3],e[5]]=[Math.sign(e[0])*sC,0,0,0]),e}row(){return[...this.state(),...this.loop.applied,this.loop.fallen?1:0]}shifted(e){return[e[2]+this.offset[2],e[4]+this.offset[4]]}estimate(e){const{before:t,y:n}=this.loop,[s,o]=[e.S??[],e.Sy??[]],r=(a,l)=>a.reduce((c,h,u)=>c+h*l[u],0);return s.map((a,l)=>r(a,t)+r(o[l],n)+this.offset[l])}}class lC{constructor(e){this.data=e,this.setup=tm(e).usual,R.send=t=>this.take(t),R.hear(e.facts.welcome),R.hear(e.facts.catalogue),this.changeTo(this.setup),window.setInterval(()=>this.tick(),16)}setup;lanes=[];periods=0;owed=0;paused=!1;speed=1;back=0;n=0;wall=performance.now();target=new Float64Array(6);steer={speed:0,rate:0};hand={force:0,start:-1,duration:1/0,height:0};active=[];pulled={until:-1,force:0};acting=new Float64Array(3);pulling=0;kept=[];score=new Oh;recorder=new mR;run={rows:0,peak:0,travel:0,from:0};thinking=0;spent=0;get facts(){const e=this.data.facts.robots[this.setup.robot];return this.setup.payload&&e.laden?{...e,...e.laden}:e}get controller(){return this.facts.controllers[this.setup.controller]??null}get t(){return this.periods*this.facts.every}take(e){switch(R.note(e,this.t),e.kind){case"Change":this.changeTo(e.setup);break;case"Drag":e.force&&!this.hand.force&&this.score.push(),this.hand={...this.hand,force:e.force,height:e.height};break;case"Strike":this.strike(e.what,e.size);break;case"Steer":this.steer={speed:e.speed,rate:e.rate};break;case"Play":[this.paused,this.speed,this.back]=[e.paused,e.speed,e.paused?this.back:0];break;case"Step":this.stepped(e.periods);break;case"Scrub":[this.paused,this.back]=[!0,e.back];break;case"StandUp":this.stand(e.pitch);break;case"Save":e.what==="csv"?this.keepTraces():this.handIn(e.name);break;default:return}(e.kind==="Drag"||e.kind==="Strike"||e.kind==="Steer")&&this.recorder.note(e,this.t),this.show()}changeTo(e){const t=this.data.facts.robots,n=Object.hasOwn(t,e.robot)?e.robot:this.setup.robot,s=t[n].controllers,r=Object.hasOwn(s,e.controller)||e.controller===Ma?e.controller:Object.keys(s)[0],a=e.gains.length===6?e.gains:s.gains?.gains??[],l=Oa.filter((M,S)=>S===0||e.bodies.includes(M)),c=e.payload?t[n].laden?.look:void 0,{payload:h,payload_height:u}=c??Gi,[d,p]=[this.setup,this.lanes.length>0&&n===this.setup.robot];this.setup={...e,robot:n,controller:r,gains:a,bodies:l,payload:h,payload_height:u},this.recorder.stop();const g=p&&l.length===this.lanes.length,_=g&&r===d.controller&&e.noise===d.noise&&e.delay===d.delay&&h===d.payload,m=p&&!this.lanes[0].loop.fallen?this.lanes[0].state():[0,0,0,0,0,0],f=l.map((M,S)=>g&&!this.lanes[S].loop.fallen?this.lanes[S].state():m);if(JSON.stringify({...d,slope:0})!==JSON.stringify({...this.setup,slope:0})&&this.score.exchanged(),_)for(const M of this.lanes)M.loop.control.gains=a;else this.build(f);g||(this.kept=[]),p||this.traced(),this.said(!p||h!==d.payload)}said(e){const{facts:t,controller:n,setup:s}=this,o={delay:this.delay(),dead_zone:t.kit?.dead_zone??0,voltage:t.kit?.voltage??-1},r={kind:"Changed",setup:s,look:t.look,bodies:s.bodies,period:t.every,controller:n?.kind??Ma,truth:n?.truth??!1,kit:o,busy:!1};if(R.hear(r),e&&R.hear(t.equations),R.analysed=null,window.clearTimeout(this.thinking),R.hear({...Xp,...n?.least}),!n)return;const{plant:a}=n;n.analysed?R.hear({...n.analysed,L:[Qp(t.every),...n.analysed.L]}):a&&(this.thinking=window.setTimeout(()=>{const l=CR(a,this.data.laws[s.robot][s.controller],s.gains);R.hear({kind:"Analysed",gain:[s.gains],...l})},tC))}traced(){R.traces.reset(this.setup.bodies.length),this.kept=[],this.periods=0}delay(){return this.setup.delay<0?this.facts.delay_own:this.setup.delay}kit(){const{kit:e,period:t}=this.facts;if(!e)return null;const n=this.setup.noise,s=e.sensors.map(o=>({...o,quantum:o.quantum*n,noise:o.noise*n,bias:o.bias*n}));return{...e,sensors:s,delay:Math.round(this.delay()/t)}}build(e){const{facts:t,setup:n,controller:s}=this,o=s?this.data.laws[n.robot][n.controller]:null,r=s?.stride??Math.round(t.every/t.period),a={law:o,reads:s?.reads??[],stride:r,gains:n.gains},l=n.bodies.map(h=>h===Oa[0]?this.data[n.payload?"laden":"motions"][n.robot]:eC(t.linear)),c=this.kit();this.lanes=l.map((h,u)=>new aC(t,h,c,{...a},e[u]??[0,0,0,0,0,0],n.seed)),this.target.fill(0),[this.owed,this.back]=[0,0],this.run={rows:0,peak:0,travel:0,from:this.lanes[0].loop.x[2]}}stand(e){[this.active,this.pulled]=[[],{until:-1,force:0}],this.hand={...this.hand,force:0},this.score=this.score.anew(e),this.build(this.lanes.map(()=>[e,0,0,0,0,0])),this.recorder.begin(this.t,e,this.steer),R.hear({kind:"Acted",t:this.t})}result(){const{rows:e,peak:t,travel:n}=this.run,{fallen:s}=this.lanes[0].loop;return{fell:s,seconds:Ro((e-1)*this.facts.every),peak:Ro(t),travel:Ro(n*this.facts.look.wheel_radius),best:Ro(this.score.run)}}handIn(e){const{facts:t}=this,n={...this.setup,...t.setup,gains:this.setup.controller==="gains"?this.setup.gains:[]},s=t.setup&&this.recorder.handIn(e,n,t.period,this.t,this.result());if(!s)return R.hear({kind:"Notice",level:"error",text:"",key:t.setup?"noRun":"noReplay",job:""});const o=URL.createObjectURL(new Blob([s],{type:"application/json"}));R.hear({kind:"Made",what:"json",name:"hand-in.json",url:o})}keepTraces(){const{t:e,x:t,volts:n}=R.traces,s=this.facts.look.command_unit,o=qs.map((h,u)=>[`truth/${h}`,Uh[u],t[0][u]]);o.push(["applied/left",s,n[0]],["applied/right",s,n[1]]);const r={robot:{name:this.setup.robot},controller:{kind:this.controller?.kind??Ma},body:{kind:"nonlinear model, in a page",real:!1}},a=JSON.stringify({units:Object.fromEntries(o.map(([h,u])=>[h,u])),origin:r}),l=e.map((h,u)=>[h,...o.map(([,,d])=>d[u])].join()),c=[`# upright-log: ${a}`,["t",...o.map(([h])=>h)].join(),...l].join(`
`)+`
`;R.hear({kind:"Made",what:"csv",name:"run.csv",url:URL.createObjectURL(new Blob([c],{type:"text/csv"}))})}strike(e,t){const{look:n,equations:s,every:o}=this.facts,r=this.t;if(this.score.push(),R.hear({kind:"Acted",t:r}),e==="pull_left"||e==="pull_right")this.pulled={until:r+kd,force:e==="pull_left"?t:-t},this.active.push({force:t,start:r,duration:kd,height:0});else if(e==="impulse"){const a=Math.max(Math.round(nC/o),1)*o;this.active.push({force:t/a,start:r,duration:a,height:n.com_height})}else{const a=-s.weight*Math.sin(t)/(n.com_height*Math.cos(t)+n.wheel_radius);this.active.push({force:a,start:r,duration:iC,height:n.com_height})}}tick(){const e=performance.now(),t=Math.min((e-this.wall)/1e3,rC);this.wall=e,!this.paused&&(this.advance(t*this.speed),this.spent+=performance.now()-e,this.show())}advance(e){const{every:t}=this.facts;for(this.owed+=e;this.owed>=t*(1-1e-9);)this.owed-=t,this.period()}stepped(e){[this.paused,this.back]=[!0,0];for(let t=0;t<e;t+=1)this.period()}period(){const{every:e,look:t,pull:n}=this.facts,{t:s}=this;this.active=this.active.filter(g=>s<g.start+g.duration-1e-9);const o=this.hand.force?[...this.active,this.hand]:this.active,r=this.acting;YR(o,s,this.setup.slope,r);const a=s<this.pulled.until-1e-9?this.pulled.force:0;this.pulling=a;const l=this.steer.speed/t.wheel_radius;this.target.set([0,0,this.target[2]+l*e,l,this.target[4]+this.steer.rate*e,this.steer.rate]),this.noted();for(const{loop:g}of this.lanes)g.twist=a*n,g.fallen||g.step(this.target,(_,m)=>m.set(r));this.periods+=1;const{x:c,applied:h,fallen:u}=this.lanes[0].loop,d=this.score.watch(e,a?0:r[0],c[0],c[1],h,u);d&&R.hear(d);const p=this.kept.at(-1);(!p||this.t-p.t>=Ud-1e-9)&&this.kept.push(this.snapshot()),this.kept.length>oC/Ud+200&&this.kept.splice(0,200)}noted(){const{x:e,fallen:t}=this.lanes[0].loop;t||(this.run.rows+=1,this.run.peak=Math.max(this.run.peak,Math.abs(e[0])),this.run.travel=Math.max(this.run.travel,Math.abs(e[2]-this.run.from)))}snapshot(){const e=this.lanes[0],t=this.facts.look.limit??1/0,n=(e.loop.sent[0]**2>=t**2?1:0)+(e.loop.sent[1]**2>=t**2?2:0);return this.n+=1,{kind:"Snapshot",n:this.n,t:this.t,x:this.lanes.map(s=>s.row()),e:this.controller?e.estimate(this.controller):[],f:[...this.acting,this.pulling],r:e.shifted(this.target),s:n,paused:!1,back:0}}show(){const e=this.snapshot();if(this.back){const s=this.kept.findLast(o=>o.t<=e.t-this.back)??this.kept[0]??e;return this.n+=1,R.hear({...s,n:this.n,paused:!0,back:this.back})}const t=R.traces.t.at(-1)??-1/0,n=this.kept.findLastIndex(s=>s.t<=t);for(const s of this.kept.slice(n+1))s.t<e.t&&R.traces.add(s);R.hear({...e,paused:this.paused})}}const cC=1e3,hC=["nonlinear","linear"],uC=["twin","nonlinear","linear","published"];let Fd=0;function Mc(){if(Yt)return tm(Yt);const{robots:i,families:e,kits:t,units:n}=R.catalogue??{robots:[],families:[],kits:[],units:{}},s=e.map(r=>r.name),o=R.role==="alone"?Gi.bodies:hC;return{usual:{...Gi,bodies:o},robots:Object.fromEntries(i.map(({name:r,kit:a})=>[r,{kit:a,controllers:s}])),kits:t,bodies:uC,parameters:Object.keys(n),keys:Object.keys(Gi)}}function zh(){return location.href.split("#")[0]+HA(R.setup,R.last.push,Mc())}function dC(){if(!ka(location.hash))return;const{setup:i,push:e,robot:t,controller:n,left:s}=VA(location.hash,Mc()),{robots:o}=Mc();R.change(i);const r=()=>[t&&N("noSuchRobot",{name:t,shown:i.robot,all:Object.keys(o).join(", ")}),n&&N("noSuchController",{name:n,shown:i.controller,all:o[i.robot].controllers.join(", ")}),s.length&&N("leftOut",{parts:s.join(", ")})].filter(Boolean).join(" ");r()&&R.say(r,"error"),R.last.name(e),window.clearTimeout(Fd);const a=()=>{Fd=R.settled?window.setTimeout(()=>(e||R.falls)&&R.send(BA(e??["tilt",el])),cC):window.setTimeout(a,100)};a()}const fC=Dh(60,i=>R.change(i)),pC=8;class mC{constructor(e){this.session=e}root=D("div",{className:"panel-body"});sliders=[];title=D("p",{className:"note"});ghost=null;load=null;build(){const e=(R.catalogue?.robots??[]).map(a=>[a.name,a.name]),t=fs(N("preset"),e,R.setup.robot,a=>R.change({robot:a,gains:[],delay:-1}),"robot"),n=(a,l,c,h,u,d)=>[a,Zn(l,{low:c,high:h,step:u,show:d,key:a},p=>fC({[a]:p}))];this.sliders=[n("slope",N("slope"),-.2,.2,.005,Nh),n("noise",N("noise"),0,10,.1,a=>`× ${at(a,2)}`),n("delay",N("delay"),0,.05,.001,a=>`${at(a*1e3,2)} ms`)];const s=D("input",{type:"checkbox",id:"ghost","data-key":"ghost",onchange:()=>R.change({bodies:s.checked?["nonlinear","linear"]:["nonlinear"]})});this.ghost=s;const o=D("input",{type:"checkbox",id:"load","data-key":"load",onchange:()=>R.change({payload:o.checked?1:0})});this.load=o;const r=st(N("ownKit"),()=>R.change({slope:0,noise:1,delay:-1,payload:0}),{className:"quiet","data-key":"own-kit"});$e(this.root,D("div",{className:"column"},t,this.title,D("label",{for:"ghost",className:"check"},s,N("ghost")),this.carried),D("div",{className:"column wide"},D("div",{className:"sliders"},...this.sliders.map(([,a])=>a.root),D("p",{className:"note"},N("stays")),r))),this.update()}carried=D("label",{for:"load",className:"check"});update(){const e=this.root.querySelector("[data-key=robot]");e&&document.activeElement!==e&&(e.value=R.setup.robot),this.ghost&&(this.ghost.checked=R.setup.bodies.length>1);const t=this.session()?.facts,n=t?.laden?.look;$e(this.carried,...n&&this.load?[this.load,N("carries",{mass:at(n.payload*1e3,3),height:at(n.payload_height*100,3)})]:[]),this.load&&(this.load.checked=R.setup.payload>0),this.title.textContent=t?`${Bt(t.title)} (${N("kit")}: ${t.kit_name})`:"";const s=this.sliders.find(([o])=>o==="delay")?.[1].root.querySelector("input");s&&(s.max=String(Math.max(.05,2*(t?.delay_own??0))));for(const[o,r]of this.sliders)r.set(o==="delay"?R.changed?.kit.delay??0:R.setup[o])}}function Od(i){const e=i.split(" ").flatMap((s,o)=>[o?" ":"",D("span",{className:"token"},s)]),t=D("code",{tabIndex:0},...e),n=st(N("copy"),()=>{getSelection()?.selectAllChildren(t),navigator.clipboard?.writeText(i).then(()=>n.textContent=N("copied"),()=>{})},{"aria-label":`${N("copy")}: ${i}`,"data-key":`copy-${i.replace(/\W+/g,"-")}`});return D("div",{className:"shell"},t,n)}class gC{root=D("div",{className:"panel-body"});shown="";build(){const{robot:e,controller:t}=R.setup;this.shown=JSON.stringify([e,t]);const n=String(parseFloat((pC*(R.changed?.look.wheel_radius??.04)).toPrecision(2))),s={robot:e,controller:t,speed:n},o=["off","gains"].includes(t),r=e==="nxtway-gs"?"--drive":"upright example",l=Ph().python.filter(([,c])=>!c.includes(r)).map(([c,h])=>[c,o?h.replace(" -c {controller}",""):h]).filter(([,c])=>!(o&&c.includes("{controller}"))).flatMap(([c,h])=>[D("dt",{},c),D("dd",{},Od(h.replace(/\{(\w+)\}/g,(u,d)=>s[d]??"")))]);$e(this.root,D("div",{className:"column full"},D("p",{className:"note"},N("pythonNote")),Od(N("install")),D("dl",{className:"commands"},...l)))}update(){this.shown!==JSON.stringify([R.setup.robot,R.setup.controller])&&this.build()}}function _C(i){return st(N("lookAtThis"),()=>{const[e,{kept:t}]=[zh(),R.last],n=()=>window.prompt(N("lookAtThis"),e),s=()=>`${N(location.protocol==="file:"?"lookHere":"lookCopied")} ${N(t)}`;navigator.clipboard?navigator.clipboard.writeText(e).then(()=>i(s),n):n()},{"data-key":"look",title:N("lookTip")})}class vC{constructor(e,t){this.credentials=e,this.say=t,R.send=n=>this.send(n),this.open()}socket=null;wait=250;closed=!1;first=!0;send(e){R.note(e,R.snapshot?.t??0),this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify(e))}open(){this.say(this.first?"connecting":"lost");const e=new URL("ws",document.baseURI);e.protocol=e.protocol.replace("http","ws"),e.hash="";const t=new WebSocket(e);this.socket=t,t.onopen=()=>this.greet(),t.onmessage=n=>this.hear(JSON.parse(n.data)),t.onclose=()=>this.lost()}greet(){const e=this.first&&ka(location.hash);this.send({kind:"Hello",version:$A,session:e?"":Fi.getItem("session")??"",token:this.credentials.token,name:this.credentials.name,setup:R.changed?R.setup:null})}hear(e){e.kind==="Snapshot"&&this.send({kind:"Ack",n:e.n}),e.kind==="Welcome"&&(Fi.setItem("session",e.session),this.wait=250,this.first=!1,this.say("connected")),e.kind==="Refused"&&(this.closed=!0,this.say("refused",e.reason)),R.hear(e)}lost(){this.closed||(this.say("lost"),window.setTimeout(()=>this.open(),this.wait),this.wait=Math.min(this.wait*1.6,3e3))}}const[bC,yC]=[.04,.25];function Bh({stable:i,poles:e}){return!i&&e.length>0}function nm(i){const e=R.lit,t=!!e?.delay_at,n=xC(t&&e?e:i);if(!t||!e){const l=Sc(i),c=n||l?"":N(Yt?"placesPython":e?.reasons.length?"placesCertificate":R.jobs.size?"placesQueued":"placesPending");return[D("p",{className:`verdict ${n||l?"bad":"open"}`},l?D("b",{},jr(i)):n&&D("b",{},`${N("thinMotors")} `),c,l?"":` ${jr(i)}`.trimEnd())]}const s=e.light==="red"||e.light==="amber"?e.light:null,o=(R.setup.payload>0?N("butPayload"):"")+(za()?N("butDelay"):""),r=n?N("thin"):e.met!==5?N("targetsMet",{met:e.met??0}).replace(/\.$/,`${o}.`):N(s==="red"?"enoughRed":s?"enoughAmber":"enough").replace(/\.$/,`${o}.`),a=Sc(i);return[D("p",{className:`verdict ${n||a?"bad":s||za()||e.met!==5?"open":"good"}`},D("b",{},a?jr(i):r),` ${MC(e)} ${SC(e)} ${a?"":jr(i)}`.trimEnd())]}function za(){const i=Yt?.facts.robots[R.setup.robot]?.delay_own,e=i===void 0||R.setup.delay<0?0:R.setup.delay-i;return Math.abs(e)<5e-4?0:e}function Sc({delay:i}){return za()>(i??1/0)}function jr(i){const e=za();if(!e)return"";const t={by:at(Math.abs(1e3*e),2),own:at(1e3*(R.setup.delay-e),2),bears:at(1e3*(i.delay??0),2)};return N(Sc(i)?"delayLost":e<0?"delayLess":i.delay===null?"delayMore":"delayUsed",t)}function xC({delay:i,gain_low:e,gain_high:t}){return(i??1/0)<im()||Math.min(1-(e??0),(t??1/0)-1)<bC}function im(){return yC*(R.changed?.period??.01)}function MC({delay:i,delay_at:e}){return i===null?N("anyDelay"):N("leastDelay",{delay:at(i*1e3,2),place:Bt(e),least:at(im()*1e3,2)})}function SC({gain_low:i,low_at:e,gain_high:t,high_at:n}){const s=r=>at(100*r,2),o={down:s(1-(i??0)),low:Bt(e)};return t===null?N("leastGainLow",o):N("leastGain",{...o,up:s(t-1),high:Bt(n)})}function wC(){const{delay_at:i,low_at:e,high_at:t}=R.lit??{delay_at:"",low_at:"",high_at:""},n=[i,e,t].every(s=>s&&s!=="both motors");return D("h4",{},N("margins"),n?` ${N("notWeakest")}`:"")}const EC=["loop","portrait","voltages","estimate","equations"],Yr=8,TC=["ψ̇","ψ̈","θ̇","θ̈","φ̇","φ̈"];class AC{root=D("div",{className:"see"});view="loop";stage=D("div",{className:"stage"});strips=[];build(){const e=EC.map(n=>[n,N(n)]),t=fs(N("viewLabel"),e,this.view,n=>{this.view=n,this.show()},"view");$e(this.root,t,this.stage),this.show()}show(){this.strips=[],this.view==="loop"?$e(this.stage,...this.loop()):this.view==="equations"?$e(this.stage,...LC()):this.view==="voltages"?this.voltages():this.view==="estimate"?this.estimate():this.portrait()}draw(){if(this.view==="portrait"&&this.portrait(),!this.strips.length)return;const e=R.traces,t=e.t.at(-1)??0;let n=e.t.length;for(;n>0&&e.t[n-1]>=t-Yr;)n-=1;const s=e.t.slice(n),o=r=>r.slice(n);if(this.view==="estimate")this.strips[0].show(s,[o(e.x[0]?.[0]??[]),o(e.estimate)],t-Yr,t);else{const r=[1,2].map((a,l)=>o(e.saturated).map((c,h)=>c&a?e.volts[l][n+h]:NaN));this.strips.forEach((a,l)=>a.show(s,[o(e.volts[l]),r[l]],t-Yr,t))}}voltages(){const{text:e,push:t}=ps(),n=R.changed?.look.command_unit??"V";this.strips=[N("leftMotor"),N("rightMotor")].map(o=>new yc(o,n,[{label:o,colour:e,dash:[]},{label:N("saturated"),colour:t,dash:[],width:5}],150,1));const s=D("p",{className:"note"},N(n==="V"?"voltagesNote":"torquesNote"));$e(this.stage,s,...this.strips.map(o=>o.root))}estimate(){if(!R.snapshot?.e.length){$e(this.stage,D("p",{className:"note"},N("noEstimate")));return}const{push:e}=ps(),t=[{label:N("truth"),colour:cs(R.changed?.bodies[0]??"twin"),dash:[]},{label:N("opinion"),colour:e,dash:[4,3]}];this.strips=[new yc(`ψ: ${N("truth")} ──  ${N("opinion")} ╌╌`,"rad",t,190,.02)],$e(this.stage,D("p",{className:"note"},N("estimateNote")),this.strips[0].root)}portrait(){const{t:e,x:t}=R.traces,n=(e.at(-1)??0)-Yr;let s=e.length;for(;s>0&&e[s-1]>=n;)s-=1;const o=(r,a)=>{const l=t.map((d,p)=>{const g=R.changed?.bodies[p]??"";return{x:d[r].slice(s),y:d[r+1].slice(s),colour:cs(g),dash:Ih(g,R.changed?.bodies??[])}}),c=(d,p)=>{const g=l.flatMap(f=>f[d]),[_,m]=[g.reduce((f,M)=>Math.min(f,M),1/0),g.reduce((f,M)=>Math.max(f,M),-1/0)];return Yp(_,m,p)},h=l.map(d=>({x:d.x.at(-1)??0,y:d.y.at(-1)??0,colour:d.colour})),u=fn(qs[r]);return Ba(u,Mr({title:`${N("portrait")}: ${u}`,xLabel:`${Vs[r]} [rad]`,yLabel:`${Vs[r+1]} [rad/s]`,lines:l,points:h,x:c("x",a[0]),y:c("y",a[1]),square:!0}))};$e(this.stage,o(0,[.03,.4]),o(2,[.5,1]),o(4,[.05,.2]))}loop(){const e=R.analysed;if(R.setup.controller==="off")return[D("p",{className:"note"},N("noLoop"))];if(!e)return[D("p",{className:"note"},N("designing"))];const t=Bh(e),n=D("p",{className:t?"verdict bad":"note"},D(t?"b":"span",{},Ar(Bt(e.words)))),s=cs("twin"),o=e.stable?nm(e):[n];return e.L.length===3&&o.push(...RC(e.L,s)),e.poles.length&&o.push(CC(e.poles,s)),o}}function RC([i,e,t],n){const s=i.map((u,d)=>20*Math.log10(Math.hypot(e[d],t[d]))),o=PC(i.map((u,d)=>Math.atan2(t[d],e[d])*180/Math.PI)),r=[i[0],i.at(-1)],a=(u,d)=>[Math.min(...u)-d,Math.max(...u)+d],l=[Mr({title:N("bode"),xLabel:"ω [rad/s]",yLabel:"|L| [dB]",lines:[{x:i,y:s,colour:n}],x:r,y:a(s,3),logX:!0,marks:[{y:0}]}),Mr({title:N("bode"),xLabel:"ω [rad/s]",yLabel:"∠L [°]",lines:[{x:i,y:o,colour:n}],x:r,y:a(o,8),logX:!0,marks:[{y:-180}]})],c=t.map(u=>-u),h=Mr({title:N("nyquist"),xLabel:"Re L",yLabel:"Im L",square:!0,x:[-3.2,1.6],y:[-2,2],circle:!0,lines:[{x:e,y:t,colour:n},{x:e,y:c,colour:n,dash:[4,3]}],points:[{x:-1,y:0,colour:ps().push,cross:!0}]});return[Ba(N("bode"),...l),Ba(N("nyquist"),h)]}function CC(i,e){const t=i.map(([o,r])=>({x:o,y:r,colour:Math.hypot(o,r)>=1?ps().push:e,cross:!0})),n=Math.max(1.15,...i.map(([o,r])=>Math.max(Math.abs(o),Math.abs(r))*1.1)),s=n*1.2;return Ba(N("poles"),Mr({title:N("poles"),xLabel:"Re z",yLabel:"Im z",points:t,x:[-s,s],y:[-n,n],square:!0,circle:!0}))}function Ar(i){return i.charAt(0).toUpperCase()+i.slice(1)}function Ba(i,...e){return D("figure",{className:"titled","aria-label":i},D("figcaption",{},i),...e)}function PC(i){let e=0;return i.map((t,n)=>(n&&(e+=Math.round((i[n-1]-t)/360)*360),t+e)).map((t,n,s)=>t-Math.round((s[0]+180)/360)*360)}function LC(){const i=R.equations;if(!i)return[];const[e,,t,n]=i.inertias.map(b=>at(b,4)),[s,o,r,a]=[i.alpha,i.beta,i.weight,i.lever].map(b=>at(b,4)),[l,c]=[at(i.swing,4),at(i.half_track,4)],h=`(${a} cos ψ − ${at(i.lever-i.inertias[1],3)})`,u=R.changed?.look.command_unit==="rad/s",[d,p,g]=u?["","τ_l","τ_r"]:[`${s} `,"v_l","v_r"],[_,m]=[`${d}(${p} + ${g})`,`2·${o} (θ̇ − ψ̇)`],f=[`${e} θ̈ + ${h} ψ̈ = ${_} − ${m} + ${a} (ψ̇² + φ̇²) sin ψ`,`${h} θ̈ + ${t} ψ̈ = −${_} + ${m} + (${r} + ${l} φ̇² cos ψ) sin ψ`,`(${n} + ${l} sin² ψ) φ̈ = ${c}·${d}(${g} − ${p}) − 2·${c}²·${o} φ̇ − (2·${l} ψ̇ cos ψ + ${a} θ̇) φ̇ sin ψ`,`${u?"τ: (θ̇ − ψ̇)˙ = (v − θ̇ + ψ̇)/T":`α = ${s}   β = ${o}`}   M g L = ${r} N m   M L R = ${a} kg m²   W/2R = ${c}`],M=(b,F)=>Ia([b,...F[0].map((L,A)=>b==="A"?Vs[A]:["v_l","v_r"][A])],F.map((L,A)=>[TC[A],...L.map(U=>at(U,4))]),"matrix"),S=i.poles.map(([b,F])=>at(b,4)+(F?` ± ${at(Math.abs(F),3)}j`:"")).join(";  ");return[D("div",{className:"equations"},...f.map(b=>D("div",{},b))),D("p",{className:"note"},N("equationsNote")),D("p",{},`${N("openPoles")}: ${S} 1/s`),D("h4",{},N("linearised")),M("A",i.A),M("B",i.B)]}const zd="The readings hardly change";function NC([i,,e,t,n]){const s=Bt(e.replace(/^\w+\//,"").replaceAll("_"," "));return D("li",{},D("b",{},[Bt(i),s].filter(Boolean).join(", ")),D("p",{},ls(Ar(Bt(t)))),D("p",{className:"note"},n?`→ ${ls(Bt(n))}`:""))}function sm(i){const e=i.text.split(`
`).filter(Boolean),t=h=>h.replace(/\bin-(?=[\w.-]+\.\w+)/g,"").replace(/\b[a-z]+(_[a-z]+)+\b/g,u=>Bt(u.replaceAll("_"," "))),n=h=>D("li",{className:"note",lang:Lh(h)?"":"en"},ls(t(Bt(h)))),s=e.filter(h=>h.startsWith(zd)),o=e.filter(h=>!h.startsWith(zd)).map(n),r=s.length?D("details",{},D("summary",{},N("notSeparated",{n:s.length})),D("ul",{className:"remarks"},...s.map(n))):null,a=i.rows.some(h=>h.at(-1)==="refused")?D("p",{className:"note"},N("refusedMeans")):null,l=h=>h.map(u=>ls(Bt(i.job==="calibrate"?u.replaceAll("_"," "):u))),c=i.job==="doctor"?D("ul",{className:"findings"},...i.rows.map(NC)):Ia(i.header.map(Bt),i.rows.map(l),i.job);return[D("h4",{},ls(t(Bt(i.title)))),i.rows.length?c:null,a,o.length?D("ul",{className:"remarks"},...o):null,r]}const DC=1e3,IC=500;class om{constructor(e){this.job=e;const t=e.startsWith("keep "),n=hn(()=>t?N("writing"):fn(e));n.id=$s("job"),this.done.setAttribute("aria-labelledby",n.id);const s=hn(()=>t?"":fn(`doing_${e}`)),o={kind:"Cancel",job:e};this.root=D("div",{className:"bar"},D("b",{},n),D("button",{type:"button",onclick:()=>R.send(o),"data-key":`stop-${e}`},hn(()=>N("stop"))),this.done,this.words,D("p",{className:"note"},s));const r=window.setInterval(()=>this.share<1?this.say():window.clearInterval(r),IC);this.say()}root;done=D("progress",{max:1});words=D("span",{className:"note"});first={share:0,at:0};left=NaN;share=0;began=performance.now();at=this.began;to(e){const t=performance.now();e>0&&!this.first.share&&(this.first={share:e,at:t}),e>this.first.share&&t>this.first.at+DC&&(this.left=(1-e)*(t-this.first.at)/(e-this.first.share)),[this.share,this.at]=[e,t],this.done.value=e,this.say()}say(){const[e,t]=[performance.now(),o=>String(Math.ceil(o/1e3))],n=this.left-(e-this.at),s=Number.isNaN(n)?N("soFar",{seconds:t(e-this.began)}):n>0?N("stillTakes",{seconds:t(n)}):N("overdue",{seconds:t(e-this.began)});this.words.textContent=this.share?`${(100*this.share).toFixed(0)} % · ${s}`:N("oneAtATime")}}const kC=["127.0.0.1","localhost","[::1]"],UC=Dh(120,i=>R.change(i));let Rl={};function yi(i){Rl={...Rl,...i},R.expect(i),UC(Rl)}class Rr{root=D("div",{className:"panel-body"});update(){}}class FC extends Rr{noCertificate=D("p",{className:"note column full"});weights=D("div",{className:"sliders"});numbers=D("div",{className:"numbers"});gain=D("div",{});light=D("div",{className:"light",role:"status"});sliders=[];shape="";bar=null;working=D("div",{});reported=null;certified=D("div",{className:"column full certified","aria-live":"polite"});build(){this.shape="",this.reported=null,$e(this.certified);const e=(R.catalogue?.families??[]).map(s=>[s.name,fn(s.name)]),t=fs(N("family"),e,R.setup.controller,s=>{R.change({controller:s,gains:s==="gains"?this.present():R.setup.gains}),s==="off"&&R.send({kind:"StandUp",pitch:el})},"controller"),n=st(N("fullCertificate"),()=>R.send({kind:"Start",job:"certify",file:""}),{"data-key":"certify"});$e(this.root,D("div",{className:"column"},t,this.weights),D("div",{className:"column full"},this.gain),D("div",{className:Yt?"column full":"column"},this.numbers),Yt?this.noCertificate:D("div",{className:"column"},this.light,n,this.working),this.certified),this.update()}certify(){this.update(),this.certified.scrollIntoView({block:"nearest"})}certifying(e){const t=this.root.querySelector("[data-key=certify]");if(t?.toggleAttribute("aria-busy",e<1),t&&(t.textContent=N("fullCertificate")+(e<1?`: ${(100*e).toFixed(0)} %`:"")),e>=1&&!this.bar)return;const n=!this.bar;this.bar??=new om("certify"),this.bar.to(e),$e(this.working,e<1?this.bar.root:null),n&&this.working.scrollIntoView({block:"nearest"}),e>=1&&(this.bar=null)}present(){return R.analysed?.gain[0]?.slice(0,6)??[]}update(){const e=this.root.querySelector("[data-key=controller]");e&&document.activeElement!==e&&(e.value=R.setup.controller);const t=`${R.setup.controller} ${R.changed?.look.command_unit} ${R.setup.controller==="gains"?this.byHand().length:""}`;t!==this.shape&&this.shapeWeights(t),this.sliders.forEach((n,s)=>n.set(R.setup.controller==="gains"?this.byHand()[s]??0:this.sizes()[s])),$e(this.gain,...this.gains()),$e(this.numbers,...this.analysis()),$e(this.light,...lm()),this.noCertificate.textContent=N(["gains","off"].includes(R.setup.controller)?"noCertificateByHand":"noCertificateHere"),this.reported!==R.certified&&(this.reported=R.certified,$e(this.certified,...this.reported?[D("p",{},N("certified")),...sm(this.reported)]:[]))}byHand(){return R.setup.gains.length?R.setup.gains:this.present()}sizes(){const e=R.changed?.look.command_unit??"V",t=[...R.catalogue?.largest??[],R.catalogue?.command[e]??1];return R.setup.largest.length===t.length?R.setup.largest:t}shapeWeights(e){this.shape=e;const t=R.catalogue?.families.find(n=>n.name===R.setup.controller);if(this.sliders=[],R.setup.controller==="gains"){const n=this.byHand(),s=Math.max(...n.map(Math.abs),.1),o=R.changed?.look.command_unit??"V",r=l=>`${o}${l%2?" s":""}/rad`,a=l=>Math.max(4*Math.abs(n[l]??0),s/4);this.sliders=Vs.map((l,c)=>Zn(`${l} ${fn(qs[c])} → u`,{low:-a(c),high:a(c),step:a(c)/500,show:h=>`${at(h,4)} ${r(c)}`,typed:r(c),key:`gain-${c}`},h=>{const u=[...this.byHand().length?this.byHand():[0,0,0,0,0,0]];u[c]=h,yi({gains:u})})),$e(this.weights,...this.sliders.map(l=>l.root))}else if(t?.weights&&!Yt){const n=[...R.catalogue?.largest??[],R.catalogue?.command[R.changed?.look.command_unit??"V"]??1];this.sliders=n.map((o,r)=>this.weight(o,r));const s=st(N("ownWeights"),()=>R.change({largest:[]}),{className:"quiet","data-key":"own-weights"});$e(this.weights,D("p",{className:"note"},N("weights")),...this.sliders.map(o=>o.root),s)}else $e(this.weights,R.setup.controller==="off"?null:D("p",{className:"note"},N(t?.weights?"fixedWeights":"noWeights")))}weight(e,t){const n=t<6?Uh[t]:R.changed?.look.command_unit??"V",s=t<6?`${Vs[t]} ${fn(qs[t])}`:N("command");return Zn(s,{low:e/10,high:e*10,log:!0,show:o=>`${at(o,2)} ${n}`,key:`weight-${t}`},o=>{const r=[...this.sizes()];r[t]=o,yi({largest:r})})}gains(){const e=R.analysed?.gain??[];return!e.length||["gains","off"].includes(R.setup.controller)?[]:[D("h4",{},N("gain")),Ia(Vs,[e[0].map(t=>at(t,3))],"gains"),D("p",{className:"note"},N("gainNote",{unit:R.changed?.look.command_unit??"V"}))]}analysis(){const e=R.analysed;if(R.setup.controller==="off")return[D("p",{className:"note"},N("noLoop"))];if(!e)return[D("p",{className:"note"},N("designing")+(R.setup.controller==="robust"?" "+N("robustTakes"):""))];const t=[],n=(r,a)=>`${r===null?"0":at(r,2)} … ${a===null?"∞":at(a,3)}`,s=[[N("gainMargin"),n(e.gain_low,e.gain_high)],[N("phaseMargin"),e.phase===null?N("unlimited"):`${at(e.phase*180/Math.PI,2)}°`],[N("delayMargin"),e.delay===null?N("unlimited"):`${at(e.delay*1e3,3)} ms`]],o=Ar(Bt(e.words));return Bh(e)?t.push(D("p",{className:"verdict bad"},D("b",{},o))):e.stable?t.push(...nm(e),wC(),Ia([],s,"margins")):t.push(D("p",{className:"note"},o)),t}}function rm(){return R.setup.controller==="off"||(R.lit?.light??"none")==="none"?"":(R.setup.payload>0?N("butPayload"):"")+(R.setup.slope?N("butSlope"):"")}function am(){const i=R.lit?.light??"none";return R.setup.controller==="off"||i==="none"&&R.analysed!==null&&Bh(R.analysed)?"red":i}function lm(){const i=R.setup.controller==="off",e=i?null:R.lit,t=am(),n=t==="none"&&!e?.reasons.length,{trying:s}=R,o=n&&s?N("tried",{n:Math.round(s.fraction*s.runs),all:s.runs}):n&&R.jobs.size?N("queued"):N(t),r=i?N("noneRed"):t==="none"&&!n?N("noCertificate"):o,a=D("span",{className:`lamp ${t}`,"aria-hidden":"true"});return[D("h4",{},N("certificate")),D("p",{className:"lit"},a,D("b",{},r+rm())),n&&!R.jobs.size?D("p",{className:"note"},N("lightNote")):null,...(e?.reasons??[]).map(l=>D("p",{className:"note"},ls(Ar(Bt(l)))+(t==="green"&&/robots fell/.test(l)?` ${N("allowed")}`:"")))]}class OC extends Rr{sliders=[];table=D("div",{className:"parameters"});fields=new Map;shown="";opened=!1;title=D("p",{className:"note"});build(){this.shown="",this.fields.clear();const e=(R.catalogue?.robots??[]).map(s=>[s.name,s.name]);e.some(([s])=>s===R.setup.robot)||e.push([R.setup.robot,R.setup.robot]);const t=fs(N("preset"),e,R.setup.robot,s=>this.choose(s),"robot");this.sliders=[["payload",Zn(N("payload"),{low:0,high:this.weight(),step:.005,show:s=>`${at(s*1e3,3)} g`,key:"payload"},s=>yi({payload:s}))],["payload_height",Zn(N("payloadHeight"),{low:0,high:.5,step:.005,show:s=>`${at(s*100,3)} cm`,key:"payload_height"},s=>yi({payload_height:s}))],["slope",Zn(N("slope"),{low:-.2,high:.2,step:.005,show:Nh,key:"slope"},s=>yi({slope:s}))],["grip",Zn(N("grip"),{low:.02,high:10,log:!0,show:s=>at(s,2),key:"grip"},s=>yi({grip:s}))]];const n=D("details",{open:this.opened,ontoggle:()=>this.opened=n.open},D("summary",{},N("numbers")),D("p",{className:"note"},N("numbersNote")),this.table);$e(this.root,D("div",{className:"column"},t,this.title,cm(N("openRobot"),".toml","robot")),D("div",{className:"column"},D("div",{className:"sliders"},...this.sliders.map(([,s])=>s.root))),D("div",{className:"column"},this.bodies()),D("div",{className:"column full"},n)),this.update()}weight(){return Math.max(.3,(R.changed?.look.weight??6)/9.81*.6)}choose(e){const t=R.catalogue?.robots.find(n=>n.name===e);t&&R.change({robot:e,numbers:{},drive:"",kit:t.kit,largest:[],gains:[],payload:0,delay:-1,voltage:-1,dead_zone:-1})}bodies(){const e=["twin","nonlinear","linear","published",...R.changed?.bodies.includes("calibrated")?["calibrated"]:[]],t=e.map(n=>{const s=$s("body"),o=D("input",{type:"checkbox",id:s,checked:R.setup.bodies.includes(n),"data-key":`body-${n}`,onchange:()=>{const r=e.filter(a=>a===n?o.checked:R.setup.bodies.includes(a));r.length?R.change({bodies:r}):o.checked=!0}});return D("label",{for:s,className:"check"},o,Kp(n))});return D("fieldset",{},D("legend",{},N("bodies")),...t)}update(){for(const[n,s]of this.sliders)s.set(R.setup[n]);this.title.textContent=Bt(R.catalogue?.robots.find(n=>n.name===R.setup.robot)?.title??"");const e=JSON.stringify([R.setup.robot,R.setup.numbers,R.changed?.bodies]);if(e===this.shown)return;const t=this.shown!=="";this.shown=e,t&&!this.root.contains(document.activeElement)&&this.build(),this.parameters()}parameters(){const t={...R.catalogue?.robots.find(s=>s.name===R.setup.robot)?.numbers??{},...R.setup.numbers};if(Object.keys(t).join()===[...this.fields.keys()].join())return this.fields.forEach((s,o)=>s.set(t[o]));this.fields.clear();const n=Object.keys(t).map(s=>{const o=$s("number"),r=Wp(l=>R.change({numbers:{...R.setup.numbers,[s]:l}}),{id:o,"data-key":`number-${s}`});this.fields.set(s,r);const a=R.catalogue?.symbols[s]??"";return D("div",{className:"parameter"},D("label",{for:o},`${Bt(s.replaceAll("_"," "))} ${a}`),r.root,D("span",{},(R.catalogue?.units[s]??"").replace(/^1$/,"")))});this.fields.forEach((s,o)=>s.set(t[o])),$e(this.table,...n,st(N("ownNumbers"),()=>R.change({numbers:{},drive:""}),{className:"quiet","data-key":"own-numbers"}))}}class zC extends Rr{sliders=[];anew=D("p",{className:"note"});build(){const e=(R.catalogue?.kits??[]).map(o=>[o,o==="ideal"?N("ideal"):o]),t=fs(N("kit"),e,R.setup.kit,o=>R.change({kit:o,delay:-1,voltage:-1,dead_zone:-1,noise:1}),"kit"),n=R.changed?.look.command_unit??"V";this.sliders=[["noise",Zn(N("noise"),{low:0,high:10,step:.1,show:o=>`× ${at(o,2)}`,key:"noise"},o=>yi({noise:o}))],["delay",Zn(N("delay"),{low:0,high:.04,step:.002,show:o=>`${at(o*1e3,2)} ms`,key:"delay"},o=>yi({delay:o}))],["voltage",Zn(N("voltage"),{low:1,high:14,step:.1,show:o=>o>0?`${at(o,3)} V`:N("unlimited"),key:"voltage"},o=>yi({voltage:o}))],["dead_zone",Zn(N("deadZone"),{low:0,high:n==="V"?2:.1,show:o=>`${at(o,2)} ${n}`,key:"dead_zone"},o=>yi({dead_zone:o}))]];const s=st(N("ownKit"),()=>R.change({noise:1,delay:-1,voltage:-1,dead_zone:-1}),{className:"quiet","data-key":"own-kit"});$e(this.root,D("div",{className:"column"},t,s),D("div",{className:"column wide"},D("div",{className:"sliders"},...this.sliders.map(([,o])=>o.root)),this.anew)),this.update()}update(){const e=R.changed?.kit??{};for(const[n,s]of this.sliders)s.set(n==="noise"?R.setup.noise:e[n]);this.anew.textContent=["gains","off"].includes(R.setup.controller)?"":N("redesigned");const t=this.root.querySelector("[data-key=kit]");t&&document.activeElement!==t&&(t.value=R.setup.kit)}}function cm(i,e,t){const n=$s("file"),s=D("input",{type:"file",id:n,accept:e,className:"file","data-key":`open-${t}`,onchange:()=>{const o=s.files?.[0];s.value="",o&&BC(o,t)}});return D("div",{className:"upload"},s,D("label",{for:n,className:"button"},i))}let ks="",hm=()=>{};async function BC(i,e){const t=`upload/${R.session}?what=${e}&name=${encodeURIComponent(i.name)}`;R.say(()=>N("uploaded",{name:i.name}));try{const n=await fetch(t,{method:"POST",body:i}),{name:s,error:o}=await n.json();o?R.say(()=>Na(o),"error"):e==="log"&&(ks=s??"",hm())}catch{R.say(()=>N("lost"),"error")}}const wc="compare.html";class HC extends Rr{bars=D("div",{className:"bars"});result=D("div",{className:"result",role:"region","aria-live":"polite"});shares=new Map;running=new Map;source="";comparison=D("p",{className:"comparison",role:"status"});robot="";failed=D("p",{className:"failed",role:"alert"});load=0;constructor(){super(),hm=()=>Hs(()=>this.build())}build(){const e=[["",N("thisRun")]];ks&&e.push([ks,ks.replace(/^in-/,"")]),ks&&(this.source=ks);const t=fs(N("source"),e,this.source,r=>this.source=r,"source"),n=r=>{$e(this.failed),this.load=this.source?0:R.setup.payload,R.send({kind:"Start",job:r,file:this.source})},s=D("div",{className:"row"},st(N("doctor"),()=>n("doctor"),{title:N("doctorTip"),"data-key":"doctor"}),st(N("calibrate"),()=>n("calibrate"),{title:N("calibrateTip"),"data-key":"calibrate"}),st(N("compare"),()=>this.compare(),{title:N("compareTip"),"data-key":"compare"})),o=".csv,.txt,.log,.tsv,.dat,.json,.mat,.parquet,.mcap";this.changed();for(const r of[this.comparison,this.failed])Da(r);$e(this.root,D("div",{className:"column"},t,cm(N("openLog"),o,"log"),s,this.failed,this.comparison,D("p",{className:"note"},N("calibrateNote")),this.bars),D("div",{className:"column wide"},this.result)),this.found()}fail(e){this.robot=R.setup.robot,$e(this.failed,hn(e)),this.failed.scrollIntoView({block:"nearest"})}changed(){if(this.robot!==R.setup.robot)for(const e of[this.comparison,this.failed])$e(e)}compare(){this.robot=R.setup.robot,$e(this.failed),R.send({kind:"Save",what:"compare",name:this.source});const e=[...this.shares.keys()].some(t=>t!=="design")?"compareWaits":"comparing";$e(this.comparison,hn(()=>N(e)))}compared(e){this.robot=R.setup.robot;const t=D("a",{href:e,target:"_blank",rel:"noopener","data-key":"open-comparison"},hn(()=>N("open"))),n=D("a",{href:e,download:wc,"data-key":"save-comparison"},hn(()=>N("saveAs",{name:wc})));$e(this.comparison,hn(()=>N("compared"))," ",t," · ",n)}progress(e,t){if(e==="keep compare"){t>=1&&!this.comparison.querySelector("a")&&$e(this.comparison);return}if(t>=1?this.shares.delete(e):this.shares.set(e,t),e==="design")return;const n=this.running.get(e)??new om(e);n.to(t),t>=1?n.root.remove():this.running.has(e)||this.bars.append(n.root),t>=1?this.running.delete(e):this.running.set(e,n)}found(){const e=R.found;if(!e)return;const t=e.job==="calibrate"&&this.load>0;$e(this.result,t&&D("p",{className:"verdict bad"},D("b",{},N("calibratedLaden",{mass:at(this.load*1e3,3)}))),...sm(e))}}class VC extends Rr{constructor(e){super(),this.picture=e}files=new Map;saved=D("p",{className:"saved"});linked=D("div",{});links=D("div",{className:"links",role:"status"},this.linked,this.saved);buildExported(){Da(this.links);const e=st(N("csv"),()=>R.send({kind:"Save",what:"csv",name:""}),{"data-key":"keep-csv"});$e(this.root,D("div",{className:"column wide"},D("p",{className:"note"},N("csvNote")),D("div",{className:"row"},e,this.pictureButton()),D("p",{className:"note"},N("keepLive")),D("p",{className:"note"},N("handInNote")),this.handIn(),this.links))}build(){Da(this.links);const e=[[N("keepData"),[["csv",N("csv")],["parquet",N("parquet")]]],[N("keepPages"),[["report",N("report")],["replay",N("replay")]]],[N("keepFiles"),[["controller",N("controllerFile")],["robot",N("robotFile")]]]],t=([o,r])=>st(r,()=>R.send({kind:"Save",what:o,name:""}),{"data-key":`keep-${o}`}),n=(o,...r)=>D("div",{},D("h4",{},o),D("div",{className:"row"},...r)),s=st(N("link"),()=>void this.copy(),{"data-key":"link"});$e(this.root,D("div",{className:"column wide"},D("p",{className:"note"},N("keepNote")),...e.map(([o,r])=>n(o,...r.map(t))),n(N("keepShow"),this.pictureButton(),s),D("p",{className:"note"},N("handInNote")),this.handIn(),this.links))}handIn(){const e=$s("student"),t=D("input",{type:"text",id:e,maxLength:40,autocomplete:"name",value:Fi.getItem("name")??"","data-key":"student"}),n=()=>{t.value.trim()?R.send({kind:"Save",what:"handin",name:t.value.trim()}):(t.focus(),R.say(()=>N("nameMissing")))};return D("div",{className:"row hand-in"},D("label",{for:e},N("yourName")),t,st(N("handIn"),n,{"data-key":"keep-handin"}))}pictureButton(){return st(N("picture"),()=>void this.photograph(),{"data-key":"picture"})}async photograph(){const e=await this.picture();e&&this.made(e.type.includes("svg")?"upright.svg":"upright.png",URL.createObjectURL(e))}async copy(){const[e,{kept:t}]=[zh(),R.last];history.replaceState(null,"",e),await navigator.clipboard?.writeText(e).catch(()=>{});const n=()=>`${N(kC.includes(location.hostname)?"linkHere":"linkCopied")} ${N(t)}`;R.say(n);const s=D("input",{readOnly:!0,value:e,"aria-label":N("link"),className:"address"});$e(this.linked,D("p",{className:"note"},hn(n)),s),s.select()}made(e,t){const n=D("a",{href:t,download:e},e);this.files.set(e,n),$e(this.saved,hn(()=>N("saved")),...[...this.files.values()].flatMap(s=>[" ",s])),n.click()}}class Bd{moments;at=0;paused=!1;speed=1;clock=performance.now();constructor(e){const t=e.filter(n=>n.kind==="Snapshot");this.moments=t.map(n=>({...n,t:n.t-t[0].t})),R.recorded=Math.max(this.length(),.02),R.send=n=>this.act(n);for(const n of e)n.kind!=="Snapshot"&&R.hear(n);window.setInterval(()=>this.tick(),20)}static inPage(){const e=document.getElementById("recording");return e?JSON.parse(e.textContent??"[]"):null}tick(){const e=performance.now();!this.paused&&this.moments.length&&(this.at+=(e-this.clock)/1e3*this.speed,this.at>this.length()&&this.rewind(),this.show()),this.clock=e}length(){return this.moments.at(-1)?.t??0}rewind(){this.at=0,R.traces.reset(this.moments[0].x.length)}show(){const e=this.at,t=R.traces.t.at(-1)??-1/0;e<t&&R.traces.until(e);const n=this.moments.filter(o=>o.t>t&&o.t<=e),s=n.at(-1)??this.moments.findLast(o=>o.t<=e);for(const o of n.slice(0,-1))R.traces.add(o);s&&R.hear({...s,paused:this.paused,back:0})}act(e){if(e.kind==="Play")this.paused=e.paused,this.speed=e.speed;else if(e.kind==="Scrub")this.at=Math.max(0,this.length()-e.back);else if(e.kind==="Step")this.paused=!0,this.at=Math.min(this.at+.02*e.periods,this.length());else if(e.kind==="StandUp")this.rewind();else return;this.show()}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Hh="170",GC=0,Hd=1,WC=2,um=1,dm=2,Ui=3,ms=0,Ln=1,Oi=2,hs=0,Lo=1,Vd=2,Gd=3,Wd=4,$C=5,Us=100,qC=101,XC=102,jC=103,YC=104,KC=200,ZC=201,JC=202,QC=203,Ec=204,Tc=205,e2=206,t2=207,n2=208,i2=209,s2=210,o2=211,r2=212,a2=213,l2=214,Ac=0,Rc=1,Cc=2,Oo=3,Pc=4,Lc=5,Nc=6,Dc=7,fm=0,c2=1,h2=2,us=0,u2=1,d2=2,f2=3,p2=4,m2=5,g2=6,_2=7,pm=300,zo=301,Bo=302,Ic=303,kc=304,tl=306,Ha=1e3,Os=1001,Uc=1002,hi=1003,v2=1004,Kr=1005,xi=1006,Cl=1007,zs=1008,qi=1009,mm=1010,gm=1011,Er=1012,Vh=1013,Xs=1014,zi=1015,Cr=1016,Gh=1017,Wh=1018,Ho=1020,_m=35902,vm=1021,bm=1022,ci=1023,ym=1024,xm=1025,No=1026,Vo=1027,Mm=1028,$h=1029,Sm=1030,qh=1031,Xh=1033,Sa=33776,wa=33777,Ea=33778,Ta=33779,Fc=35840,Oc=35841,zc=35842,Bc=35843,Hc=36196,Vc=37492,Gc=37496,Wc=37808,$c=37809,qc=37810,Xc=37811,jc=37812,Yc=37813,Kc=37814,Zc=37815,Jc=37816,Qc=37817,eh=37818,th=37819,nh=37820,ih=37821,Aa=36492,sh=36494,oh=36495,wm=36283,rh=36284,ah=36285,lh=36286,b2=3200,y2=3201,Em=0,x2=1,as="",zn="srgb",Yo="srgb-linear",nl="linear",Rt="srgb",ho=7680,$d=519,M2=512,S2=513,w2=514,Tm=515,E2=516,T2=517,A2=518,R2=519,qd=35044,Xd="300 es",Bi=2e3,Va=2001;class Ko{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){if(this._listeners===void 0)return!1;const n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){if(this._listeners===void 0)return;const s=this._listeners[e];if(s!==void 0){const o=s.indexOf(t);o!==-1&&s.splice(o,1)}}dispatchEvent(e){if(this._listeners===void 0)return;const n=this._listeners[e.type];if(n!==void 0){e.target=this;const s=n.slice(0);for(let o=0,r=s.length;o<r;o++)s[o].call(this,e);e.target=null}}}const _n=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Pl=Math.PI/180,ch=180/Math.PI;function Pr(){const i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(_n[i&255]+_n[i>>8&255]+_n[i>>16&255]+_n[i>>24&255]+"-"+_n[e&255]+_n[e>>8&255]+"-"+_n[e>>16&15|64]+_n[e>>24&255]+"-"+_n[t&63|128]+_n[t>>8&255]+"-"+_n[t>>16&255]+_n[t>>24&255]+_n[n&255]+_n[n>>8&255]+_n[n>>16&255]+_n[n>>24&255]).toLowerCase()}function Pn(i,e,t){return Math.max(e,Math.min(t,i))}function C2(i,e){return(i%e+e)%e}function Ll(i,e,t){return(1-t)*i+t*e}function ar(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Cn(i,e){switch(e.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class vt{constructor(e=0,t=0){vt.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Pn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const n=Math.cos(t),s=Math.sin(t),o=this.x-e.x,r=this.y-e.y;return this.x=o*n-r*s+e.x,this.y=o*s+r*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class tt{constructor(e,t,n,s,o,r,a,l,c){tt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,r,a,l,c)}set(e,t,n,s,o,r,a,l,c){const h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=o,h[5]=l,h[6]=n,h[7]=r,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,o=this.elements,r=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],p=n[5],g=n[8],_=s[0],m=s[3],f=s[6],M=s[1],S=s[4],b=s[7],F=s[2],L=s[5],A=s[8];return o[0]=r*_+a*M+l*F,o[3]=r*m+a*S+l*L,o[6]=r*f+a*b+l*A,o[1]=c*_+h*M+u*F,o[4]=c*m+h*S+u*L,o[7]=c*f+h*b+u*A,o[2]=d*_+p*M+g*F,o[5]=d*m+p*S+g*L,o[8]=d*f+p*b+g*A,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],r=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*r*h-t*a*c-n*o*h+n*a*l+s*o*c-s*r*l}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],r=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*r-a*c,d=a*l-h*o,p=c*o-r*l,g=t*u+n*d+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const _=1/g;return e[0]=u*_,e[1]=(s*c-h*n)*_,e[2]=(a*n-s*r)*_,e[3]=d*_,e[4]=(h*t-s*l)*_,e[5]=(s*o-a*t)*_,e[6]=p*_,e[7]=(n*l-c*t)*_,e[8]=(r*t-n*o)*_,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,o,r,a){const l=Math.cos(o),c=Math.sin(o);return this.set(n*l,n*c,-n*(l*r+c*a)+r+e,-s*c,s*l,-s*(-c*r+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(Nl.makeScale(e,t)),this}rotate(e){return this.premultiply(Nl.makeRotation(-e)),this}translate(e,t){return this.premultiply(Nl.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const Nl=new tt;function Am(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Ga(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function P2(){const i=Ga("canvas");return i.style.display="block",i}const jd={};function _r(i){i in jd||(jd[i]=!0,console.warn(i))}function L2(i,e,t){return new Promise(function(n,s){function o(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(o,t);break;default:n()}}setTimeout(o,t)})}function N2(i){const e=i.elements;e[2]=.5*e[2]+.5*e[3],e[6]=.5*e[6]+.5*e[7],e[10]=.5*e[10]+.5*e[11],e[14]=.5*e[14]+.5*e[15]}function D2(i){const e=i.elements;e[11]===-1?(e[10]=-e[10]-1,e[14]=-e[14]):(e[10]=-e[10],e[14]=-e[14]+1)}const _t={enabled:!0,workingColorSpace:Yo,spaces:{},convert:function(i,e,t){return this.enabled===!1||e===t||!e||!t||(this.spaces[e].transfer===Rt&&(i.r=Wi(i.r),i.g=Wi(i.g),i.b=Wi(i.b)),this.spaces[e].primaries!==this.spaces[t].primaries&&(i.applyMatrix3(this.spaces[e].toXYZ),i.applyMatrix3(this.spaces[t].fromXYZ)),this.spaces[t].transfer===Rt&&(i.r=Do(i.r),i.g=Do(i.g),i.b=Do(i.b))),i},fromWorkingColorSpace:function(i,e){return this.convert(i,this.workingColorSpace,e)},toWorkingColorSpace:function(i,e){return this.convert(i,e,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===as?nl:this.spaces[i].transfer},getLuminanceCoefficients:function(i,e=this.workingColorSpace){return i.fromArray(this.spaces[e].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,e,t){return i.copy(this.spaces[e].toXYZ).multiply(this.spaces[t].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Wi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Do(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const Yd=[.64,.33,.3,.6,.15,.06],Kd=[.2126,.7152,.0722],Zd=[.3127,.329],Jd=new tt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Qd=new tt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);_t.define({[Yo]:{primaries:Yd,whitePoint:Zd,transfer:nl,toXYZ:Jd,fromXYZ:Qd,luminanceCoefficients:Kd,workingColorSpaceConfig:{unpackColorSpace:zn},outputColorSpaceConfig:{drawingBufferColorSpace:zn}},[zn]:{primaries:Yd,whitePoint:Zd,transfer:Rt,toXYZ:Jd,fromXYZ:Qd,luminanceCoefficients:Kd,outputColorSpaceConfig:{drawingBufferColorSpace:zn}}});let uo;class I2{static getDataURL(e){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let t;if(e instanceof HTMLCanvasElement)t=e;else{uo===void 0&&(uo=Ga("canvas")),uo.width=e.width,uo.height=e.height;const n=uo.getContext("2d");e instanceof ImageData?n.putImageData(e,0,0):n.drawImage(e,0,0,e.width,e.height),t=uo}return t.width>2048||t.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",e),t.toDataURL("image/jpeg",.6)):t.toDataURL("image/png")}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=Ga("canvas");t.width=e.width,t.height=e.height;const n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);const s=n.getImageData(0,0,e.width,e.height),o=s.data;for(let r=0;r<o.length;r++)o[r]=Wi(o[r]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Wi(t[n]/255)*255):t[n]=Wi(t[n]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let k2=0;class Rm{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:k2++}),this.uuid=Pr(),this.data=e,this.dataReady=!0,this.version=0}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let o;if(Array.isArray(s)){o=[];for(let r=0,a=s.length;r<a;r++)s[r].isDataTexture?o.push(Dl(s[r].image)):o.push(Dl(s[r]))}else o=Dl(s);n.url=o}return t||(e.images[this.uuid]=n),n}}function Dl(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?I2.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let U2=0;class Tn extends Ko{constructor(e=Tn.DEFAULT_IMAGE,t=Tn.DEFAULT_MAPPING,n=Os,s=Os,o=xi,r=zs,a=ci,l=qi,c=Tn.DEFAULT_ANISOTROPY,h=as){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:U2++}),this.uuid=Pr(),this.name="",this.source=new Rm(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=o,this.minFilter=r,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new vt(0,0),this.repeat=new vt(1,1),this.center=new vt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new tt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==pm)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ha:e.x=e.x-Math.floor(e.x);break;case Os:e.x=e.x<0?0:1;break;case Uc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ha:e.y=e.y-Math.floor(e.y);break;case Os:e.y=e.y<0?0:1;break;case Uc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}Tn.DEFAULT_IMAGE=null;Tn.DEFAULT_MAPPING=pm;Tn.DEFAULT_ANISOTROPY=1;class Wt{constructor(e=0,t=0,n=0,s=1){Wt.prototype.isVector4=!0,this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,o=this.w,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s+r[12]*o,this.y=r[1]*t+r[5]*n+r[9]*s+r[13]*o,this.z=r[2]*t+r[6]*n+r[10]*s+r[14]*o,this.w=r[3]*t+r[7]*n+r[11]*s+r[15]*o,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,o;const l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],p=l[5],g=l[9],_=l[2],m=l[6],f=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+_)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+f-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const S=(c+1)/2,b=(p+1)/2,F=(f+1)/2,L=(h+d)/4,A=(u+_)/4,U=(g+m)/4;return S>b&&S>F?S<.01?(n=0,s=.707106781,o=.707106781):(n=Math.sqrt(S),s=L/n,o=A/n):b>F?b<.01?(n=.707106781,s=0,o=.707106781):(s=Math.sqrt(b),n=L/s,o=U/s):F<.01?(n=.707106781,s=.707106781,o=0):(o=Math.sqrt(F),n=A/o,s=U/o),this.set(n,s,o,t),this}let M=Math.sqrt((m-g)*(m-g)+(u-_)*(u-_)+(d-h)*(d-h));return Math.abs(M)<.001&&(M=1),this.x=(m-g)/M,this.y=(u-_)/M,this.z=(d-h)/M,this.w=Math.acos((c+p+f-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this.w=Math.max(e.w,Math.min(t.w,this.w)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this.w=Math.max(e,Math.min(t,this.w)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class F2 extends Ko{constructor(e=1,t=1,n={}){super(),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=1,this.scissor=new Wt(0,0,e,t),this.scissorTest=!1,this.viewport=new Wt(0,0,e,t);const s={width:e,height:t,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:xi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const o=new Tn(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);o.flipY=!1,o.generateMipmaps=n.generateMipmaps,o.internalFormat=n.internalFormat,this.textures=[];const r=n.count;for(let a=0;a<r;a++)this.textures[a]=o.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,o=this.textures.length;s<o;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let n=0,s=e.textures.length;n<s;n++)this.textures[n]=e.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const t=Object.assign({},e.texture.image);return this.texture.source=new Rm(t),this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class js extends F2{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}}class Cm extends Tn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=hi,this.minFilter=hi,this.wrapR=Os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class O2 extends Tn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=hi,this.minFilter=hi,this.wrapR=Os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Lr{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,o,r,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3];const d=o[r+0],p=o[r+1],g=o[r+2],_=o[r+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u;return}if(a===1){e[t+0]=d,e[t+1]=p,e[t+2]=g,e[t+3]=_;return}if(u!==_||l!==d||c!==p||h!==g){let m=1-a;const f=l*d+c*p+h*g+u*_,M=f>=0?1:-1,S=1-f*f;if(S>Number.EPSILON){const F=Math.sqrt(S),L=Math.atan2(F,f*M);m=Math.sin(m*L)/F,a=Math.sin(a*L)/F}const b=a*M;if(l=l*m+d*b,c=c*m+p*b,h=h*m+g*b,u=u*m+_*b,m===1-a){const F=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=F,c*=F,h*=F,u*=F}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,o,r){const a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=o[r],d=o[r+1],p=o[r+2],g=o[r+3];return e[t]=a*g+h*u+l*p-c*d,e[t+1]=l*g+h*d+c*u-a*p,e[t+2]=c*g+h*p+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const n=e._x,s=e._y,o=e._z,r=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(o/2),d=l(n/2),p=l(s/2),g=l(o/2);switch(r){case"XYZ":this._x=d*h*u+c*p*g,this._y=c*p*u-d*h*g,this._z=c*h*g+d*p*u,this._w=c*h*u-d*p*g;break;case"YXZ":this._x=d*h*u+c*p*g,this._y=c*p*u-d*h*g,this._z=c*h*g-d*p*u,this._w=c*h*u+d*p*g;break;case"ZXY":this._x=d*h*u-c*p*g,this._y=c*p*u+d*h*g,this._z=c*h*g+d*p*u,this._w=c*h*u-d*p*g;break;case"ZYX":this._x=d*h*u-c*p*g,this._y=c*p*u+d*h*g,this._z=c*h*g-d*p*u,this._w=c*h*u+d*p*g;break;case"YZX":this._x=d*h*u+c*p*g,this._y=c*p*u+d*h*g,this._z=c*h*g-d*p*u,this._w=c*h*u-d*p*g;break;case"XZY":this._x=d*h*u-c*p*g,this._y=c*p*u-d*h*g,this._z=c*h*g+d*p*u,this._w=c*h*u+d*p*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+r)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,n=t[0],s=t[4],o=t[8],r=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){const p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(h-l)*p,this._y=(o-c)*p,this._z=(r-s)*p}else if(n>a&&n>u){const p=2*Math.sqrt(1+n-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+r)/p,this._z=(o+c)/p}else if(a>u){const p=2*Math.sqrt(1+a-n-u);this._w=(o-c)/p,this._x=(s+r)/p,this._y=.25*p,this._z=(l+h)/p}else{const p=2*Math.sqrt(1+u-n-a);this._w=(r-s)/p,this._x=(o+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<Number.EPSILON?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Pn(this.dot(e),-1,1)))}rotateTowards(e,t){const n=this.angleTo(e);if(n===0)return this;const s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const n=e._x,s=e._y,o=e._z,r=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+r*a+s*c-o*l,this._y=s*h+r*l+o*a-n*c,this._z=o*h+r*c+n*l-s*a,this._w=r*h-n*a-s*l-o*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);const n=this._x,s=this._y,o=this._z,r=this._w;let a=r*e._w+n*e._x+s*e._y+o*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=r,this._x=n,this._y=s,this._z=o,this;const l=1-a*a;if(l<=Number.EPSILON){const p=1-t;return this._w=p*r+t*this._w,this._x=p*n+t*this._x,this._y=p*s+t*this._y,this._z=p*o+t*this._z,this.normalize(),this}const c=Math.sqrt(l),h=Math.atan2(c,a),u=Math.sin((1-t)*h)/c,d=Math.sin(t*h)/c;return this._w=r*u+this._w*d,this._x=n*u+this._x*d,this._y=s*u+this._y*d,this._z=o*u+this._z*d,this._onChangeCallback(),this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),o=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),o*Math.sin(t),o*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class te{constructor(e=0,t=0,n=0){te.prototype.isVector3=!0,this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(ef.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(ef.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[3]*n+o[6]*s,this.y=o[1]*t+o[4]*n+o[7]*s,this.z=o[2]*t+o[5]*n+o[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,n=this.y,s=this.z,o=e.elements,r=1/(o[3]*t+o[7]*n+o[11]*s+o[15]);return this.x=(o[0]*t+o[4]*n+o[8]*s+o[12])*r,this.y=(o[1]*t+o[5]*n+o[9]*s+o[13])*r,this.z=(o[2]*t+o[6]*n+o[10]*s+o[14])*r,this}applyQuaternion(e){const t=this.x,n=this.y,s=this.z,o=e.x,r=e.y,a=e.z,l=e.w,c=2*(r*s-a*n),h=2*(a*t-o*s),u=2*(o*n-r*t);return this.x=t+l*c+r*u-a*h,this.y=n+l*h+a*c-o*u,this.z=s+l*u+o*h-r*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,n=this.y,s=this.z,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s,this.y=o[1]*t+o[5]*n+o[9]*s,this.z=o[2]*t+o[6]*n+o[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Math.max(e.x,Math.min(t.x,this.x)),this.y=Math.max(e.y,Math.min(t.y,this.y)),this.z=Math.max(e.z,Math.min(t.z,this.z)),this}clampScalar(e,t){return this.x=Math.max(e,Math.min(t,this.x)),this.y=Math.max(e,Math.min(t,this.y)),this.z=Math.max(e,Math.min(t,this.z)),this}clampLength(e,t){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(e,Math.min(t,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const n=e.x,s=e.y,o=e.z,r=t.x,a=t.y,l=t.z;return this.x=s*l-o*a,this.y=o*r-n*l,this.z=n*a-s*r,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Il.copy(this).projectOnVector(e),this.sub(Il)}reflect(e){return this.sub(Il.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const n=this.dot(e)/t;return Math.acos(Pn(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){const s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Il=new te,ef=new Lr;class Nr{constructor(e=new te(1/0,1/0,1/0),t=new te(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ti.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ti.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const n=ti.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const n=e.geometry;if(n!==void 0){const o=n.getAttribute("position");if(t===!0&&o!==void 0&&e.isInstancedMesh!==!0)for(let r=0,a=o.count;r<a;r++)e.isMesh===!0?e.getVertexPosition(r,ti):ti.fromBufferAttribute(o,r),ti.applyMatrix4(e.matrixWorld),this.expandByPoint(ti);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Zr.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Zr.copy(n.boundingBox)),Zr.applyMatrix4(e.matrixWorld),this.union(Zr)}const s=e.children;for(let o=0,r=s.length;o<r;o++)this.expandByObject(s[o],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ti),ti.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(lr),Jr.subVectors(this.max,lr),fo.subVectors(e.a,lr),po.subVectors(e.b,lr),mo.subVectors(e.c,lr),Ji.subVectors(po,fo),Qi.subVectors(mo,po),ws.subVectors(fo,mo);let t=[0,-Ji.z,Ji.y,0,-Qi.z,Qi.y,0,-ws.z,ws.y,Ji.z,0,-Ji.x,Qi.z,0,-Qi.x,ws.z,0,-ws.x,-Ji.y,Ji.x,0,-Qi.y,Qi.x,0,-ws.y,ws.x,0];return!kl(t,fo,po,mo,Jr)||(t=[1,0,0,0,1,0,0,0,1],!kl(t,fo,po,mo,Jr))?!1:(Qr.crossVectors(Ji,Qi),t=[Qr.x,Qr.y,Qr.z],kl(t,fo,po,mo,Jr))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ti).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ti).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Li[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Li[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Li[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Li[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Li[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Li[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Li[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Li[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Li),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}}const Li=[new te,new te,new te,new te,new te,new te,new te,new te],ti=new te,Zr=new Nr,fo=new te,po=new te,mo=new te,Ji=new te,Qi=new te,ws=new te,lr=new te,Jr=new te,Qr=new te,Es=new te;function kl(i,e,t,n,s){for(let o=0,r=i.length-3;o<=r;o+=3){Es.fromArray(i,o);const a=s.x*Math.abs(Es.x)+s.y*Math.abs(Es.y)+s.z*Math.abs(Es.z),l=e.dot(Es),c=t.dot(Es),h=n.dot(Es);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const z2=new Nr,cr=new te,Ul=new te;class jh{constructor(e=new te,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const n=this.center;t!==void 0?n.copy(t):z2.setFromPoints(e).getCenter(n);let s=0;for(let o=0,r=e.length;o<r;o++)s=Math.max(s,n.distanceToSquared(e[o]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;cr.subVectors(e,this.center);const t=cr.lengthSq();if(t>this.radius*this.radius){const n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(cr,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ul.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(cr.copy(e.center).add(Ul)),this.expandByPoint(cr.copy(e.center).sub(Ul))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Ni=new te,Fl=new te,ea=new te,es=new te,Ol=new te,ta=new te,zl=new te;class Pm{constructor(e=new te,t=new te(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ni)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=Ni.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ni.copy(this.origin).addScaledVector(this.direction,t),Ni.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Fl.copy(e).add(t).multiplyScalar(.5),ea.copy(t).sub(e).normalize(),es.copy(this.origin).sub(Fl);const o=e.distanceTo(t)*.5,r=-this.direction.dot(ea),a=es.dot(this.direction),l=-es.dot(ea),c=es.lengthSq(),h=Math.abs(1-r*r);let u,d,p,g;if(h>0)if(u=r*l-a,d=r*a-l,g=o*h,u>=0)if(d>=-g)if(d<=g){const _=1/h;u*=_,d*=_,p=u*(u+r*d+2*a)+d*(r*u+d+2*l)+c}else d=o,u=Math.max(0,-(r*d+a)),p=-u*u+d*(d+2*l)+c;else d=-o,u=Math.max(0,-(r*d+a)),p=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-r*o+a)),d=u>0?-o:Math.min(Math.max(-o,-l),o),p=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-o,-l),o),p=d*(d+2*l)+c):(u=Math.max(0,-(r*o+a)),d=u>0?o:Math.min(Math.max(-o,-l),o),p=-u*u+d*(d+2*l)+c);else d=r>0?-o:o,u=Math.max(0,-(r*d+a)),p=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Fl).addScaledVector(ea,d),p}intersectSphere(e,t){Ni.subVectors(e.center,this.origin);const n=Ni.dot(this.direction),s=Ni.dot(Ni)-n*n,o=e.radius*e.radius;if(s>o)return null;const r=Math.sqrt(o-s),a=n-r,l=n+r;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){const n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,o,r,a,l;const c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(o=(e.min.y-d.y)*h,r=(e.max.y-d.y)*h):(o=(e.max.y-d.y)*h,r=(e.min.y-d.y)*h),n>r||o>s||((o>n||isNaN(n))&&(n=o),(r<s||isNaN(s))&&(s=r),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ni)!==null}intersectTriangle(e,t,n,s,o){Ol.subVectors(t,e),ta.subVectors(n,e),zl.crossVectors(Ol,ta);let r=this.direction.dot(zl),a;if(r>0){if(s)return null;a=1}else if(r<0)a=-1,r=-r;else return null;es.subVectors(this.origin,e);const l=a*this.direction.dot(ta.crossVectors(es,ta));if(l<0)return null;const c=a*this.direction.dot(Ol.cross(es));if(c<0||l+c>r)return null;const h=-a*es.dot(zl);return h<0?null:this.at(h/r,o)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Ht{constructor(e,t,n,s,o,r,a,l,c,h,u,d,p,g,_,m){Ht.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,o,r,a,l,c,h,u,d,p,g,_,m)}set(e,t,n,s,o,r,a,l,c,h,u,d,p,g,_,m){const f=this.elements;return f[0]=e,f[4]=t,f[8]=n,f[12]=s,f[1]=o,f[5]=r,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=u,f[14]=d,f[3]=p,f[7]=g,f[11]=_,f[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ht().fromArray(this.elements)}copy(e){const t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){const t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){const t=this.elements,n=e.elements,s=1/go.setFromMatrixColumn(e,0).length(),o=1/go.setFromMatrixColumn(e,1).length(),r=1/go.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*o,t[5]=n[5]*o,t[6]=n[6]*o,t[7]=0,t[8]=n[8]*r,t[9]=n[9]*r,t[10]=n[10]*r,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,n=e.x,s=e.y,o=e.z,r=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(o),u=Math.sin(o);if(e.order==="XYZ"){const d=r*h,p=r*u,g=a*h,_=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=p+g*c,t[5]=d-_*c,t[9]=-a*l,t[2]=_-d*c,t[6]=g+p*c,t[10]=r*l}else if(e.order==="YXZ"){const d=l*h,p=l*u,g=c*h,_=c*u;t[0]=d+_*a,t[4]=g*a-p,t[8]=r*c,t[1]=r*u,t[5]=r*h,t[9]=-a,t[2]=p*a-g,t[6]=_+d*a,t[10]=r*l}else if(e.order==="ZXY"){const d=l*h,p=l*u,g=c*h,_=c*u;t[0]=d-_*a,t[4]=-r*u,t[8]=g+p*a,t[1]=p+g*a,t[5]=r*h,t[9]=_-d*a,t[2]=-r*c,t[6]=a,t[10]=r*l}else if(e.order==="ZYX"){const d=r*h,p=r*u,g=a*h,_=a*u;t[0]=l*h,t[4]=g*c-p,t[8]=d*c+_,t[1]=l*u,t[5]=_*c+d,t[9]=p*c-g,t[2]=-c,t[6]=a*l,t[10]=r*l}else if(e.order==="YZX"){const d=r*l,p=r*c,g=a*l,_=a*c;t[0]=l*h,t[4]=_-d*u,t[8]=g*u+p,t[1]=u,t[5]=r*h,t[9]=-a*h,t[2]=-c*h,t[6]=p*u+g,t[10]=d-_*u}else if(e.order==="XZY"){const d=r*l,p=r*c,g=a*l,_=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+_,t[5]=r*h,t[9]=p*u-g,t[2]=g*u-p,t[6]=a*h,t[10]=_*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(B2,e,H2)}lookAt(e,t,n){const s=this.elements;return Un.subVectors(e,t),Un.lengthSq()===0&&(Un.z=1),Un.normalize(),ts.crossVectors(n,Un),ts.lengthSq()===0&&(Math.abs(n.z)===1?Un.x+=1e-4:Un.z+=1e-4,Un.normalize(),ts.crossVectors(n,Un)),ts.normalize(),na.crossVectors(Un,ts),s[0]=ts.x,s[4]=na.x,s[8]=Un.x,s[1]=ts.y,s[5]=na.y,s[9]=Un.y,s[2]=ts.z,s[6]=na.z,s[10]=Un.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const n=e.elements,s=t.elements,o=this.elements,r=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],p=n[13],g=n[2],_=n[6],m=n[10],f=n[14],M=n[3],S=n[7],b=n[11],F=n[15],L=s[0],A=s[4],U=s[8],E=s[12],x=s[1],C=s[5],V=s[9],O=s[13],q=s[2],$=s[6],X=s[10],Y=s[14],ee=s[3],ae=s[7],ce=s[11],_e=s[15];return o[0]=r*L+a*x+l*q+c*ee,o[4]=r*A+a*C+l*$+c*ae,o[8]=r*U+a*V+l*X+c*ce,o[12]=r*E+a*O+l*Y+c*_e,o[1]=h*L+u*x+d*q+p*ee,o[5]=h*A+u*C+d*$+p*ae,o[9]=h*U+u*V+d*X+p*ce,o[13]=h*E+u*O+d*Y+p*_e,o[2]=g*L+_*x+m*q+f*ee,o[6]=g*A+_*C+m*$+f*ae,o[10]=g*U+_*V+m*X+f*ce,o[14]=g*E+_*O+m*Y+f*_e,o[3]=M*L+S*x+b*q+F*ee,o[7]=M*A+S*C+b*$+F*ae,o[11]=M*U+S*V+b*X+F*ce,o[15]=M*E+S*O+b*Y+F*_e,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],n=e[4],s=e[8],o=e[12],r=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],p=e[14],g=e[3],_=e[7],m=e[11],f=e[15];return g*(+o*l*u-s*c*u-o*a*d+n*c*d+s*a*p-n*l*p)+_*(+t*l*p-t*c*d+o*r*d-s*r*p+s*c*h-o*l*h)+m*(+t*c*u-t*a*p-o*r*u+n*r*p+o*a*h-n*c*h)+f*(-s*a*h-t*l*u+t*a*d+s*r*u-n*r*d+n*l*h)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){const e=this.elements,t=e[0],n=e[1],s=e[2],o=e[3],r=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],p=e[11],g=e[12],_=e[13],m=e[14],f=e[15],M=u*m*c-_*d*c+_*l*p-a*m*p-u*l*f+a*d*f,S=g*d*c-h*m*c-g*l*p+r*m*p+h*l*f-r*d*f,b=h*_*c-g*u*c+g*a*p-r*_*p-h*a*f+r*u*f,F=g*u*l-h*_*l-g*a*d+r*_*d+h*a*m-r*u*m,L=t*M+n*S+s*b+o*F;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const A=1/L;return e[0]=M*A,e[1]=(_*d*o-u*m*o-_*s*p+n*m*p+u*s*f-n*d*f)*A,e[2]=(a*m*o-_*l*o+_*s*c-n*m*c-a*s*f+n*l*f)*A,e[3]=(u*l*o-a*d*o-u*s*c+n*d*c+a*s*p-n*l*p)*A,e[4]=S*A,e[5]=(h*m*o-g*d*o+g*s*p-t*m*p-h*s*f+t*d*f)*A,e[6]=(g*l*o-r*m*o-g*s*c+t*m*c+r*s*f-t*l*f)*A,e[7]=(r*d*o-h*l*o+h*s*c-t*d*c-r*s*p+t*l*p)*A,e[8]=b*A,e[9]=(g*u*o-h*_*o-g*n*p+t*_*p+h*n*f-t*u*f)*A,e[10]=(r*_*o-g*a*o+g*n*c-t*_*c-r*n*f+t*a*f)*A,e[11]=(h*a*o-r*u*o-h*n*c+t*u*c+r*n*p-t*a*p)*A,e[12]=F*A,e[13]=(h*_*s-g*u*s+g*n*d-t*_*d-h*n*m+t*u*m)*A,e[14]=(g*a*s-r*_*s-g*n*l+t*_*l+r*n*m-t*a*m)*A,e[15]=(r*u*s-h*a*s+h*n*l-t*u*l-r*n*d+t*a*d)*A,this}scale(e){const t=this.elements,n=e.x,s=e.y,o=e.z;return t[0]*=n,t[4]*=s,t[8]*=o,t[1]*=n,t[5]*=s,t[9]*=o,t[2]*=n,t[6]*=s,t[10]*=o,t[3]*=n,t[7]*=s,t[11]*=o,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const n=Math.cos(t),s=Math.sin(t),o=1-n,r=e.x,a=e.y,l=e.z,c=o*r,h=o*a;return this.set(c*r+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*r,0,c*l-s*a,h*l+s*r,o*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,o,r){return this.set(1,n,o,0,e,1,r,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){const s=this.elements,o=t._x,r=t._y,a=t._z,l=t._w,c=o+o,h=r+r,u=a+a,d=o*c,p=o*h,g=o*u,_=r*h,m=r*u,f=a*u,M=l*c,S=l*h,b=l*u,F=n.x,L=n.y,A=n.z;return s[0]=(1-(_+f))*F,s[1]=(p+b)*F,s[2]=(g-S)*F,s[3]=0,s[4]=(p-b)*L,s[5]=(1-(d+f))*L,s[6]=(m+M)*L,s[7]=0,s[8]=(g+S)*A,s[9]=(m-M)*A,s[10]=(1-(d+_))*A,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){const s=this.elements;let o=go.set(s[0],s[1],s[2]).length();const r=go.set(s[4],s[5],s[6]).length(),a=go.set(s[8],s[9],s[10]).length();this.determinant()<0&&(o=-o),e.x=s[12],e.y=s[13],e.z=s[14],ni.copy(this);const c=1/o,h=1/r,u=1/a;return ni.elements[0]*=c,ni.elements[1]*=c,ni.elements[2]*=c,ni.elements[4]*=h,ni.elements[5]*=h,ni.elements[6]*=h,ni.elements[8]*=u,ni.elements[9]*=u,ni.elements[10]*=u,t.setFromRotationMatrix(ni),n.x=o,n.y=r,n.z=a,this}makePerspective(e,t,n,s,o,r,a=Bi){const l=this.elements,c=2*o/(t-e),h=2*o/(n-s),u=(t+e)/(t-e),d=(n+s)/(n-s);let p,g;if(a===Bi)p=-(r+o)/(r-o),g=-2*r*o/(r-o);else if(a===Va)p=-r/(r-o),g=-r*o/(r-o);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=u,l[12]=0,l[1]=0,l[5]=h,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,o,r,a=Bi){const l=this.elements,c=1/(t-e),h=1/(n-s),u=1/(r-o),d=(t+e)*c,p=(n+s)*h;let g,_;if(a===Bi)g=(r+o)*u,_=-2*u;else if(a===Va)g=o*u,_=-1*u;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-d,l[1]=0,l[5]=2*h,l[9]=0,l[13]=-p,l[2]=0,l[6]=0,l[10]=_,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){const t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){const n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}}const go=new te,ni=new Ht,B2=new te(0,0,0),H2=new te(1,1,1),ts=new te,na=new te,Un=new te,tf=new Ht,nf=new Lr;class Ti{constructor(e=0,t=0,n=0,s=Ti.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){const s=e.elements,o=s[0],r=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],p=s[10];switch(t){case"XYZ":this._y=Math.asin(Pn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-r,o)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Pn(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,o),this._z=0);break;case"ZXY":this._x=Math.asin(Pn(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-r,c)):(this._y=0,this._z=Math.atan2(l,o));break;case"ZYX":this._y=Math.asin(-Pn(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,o)):(this._x=0,this._z=Math.atan2(-r,c));break;case"YZX":this._z=Math.asin(Pn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,o)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-Pn(r,-1,1)),Math.abs(r)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,o)):(this._x=Math.atan2(-h,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return tf.makeRotationFromQuaternion(e),this.setFromRotationMatrix(tf,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return nf.setFromEuler(this),this.setFromQuaternion(nf,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Ti.DEFAULT_ORDER="XYZ";class Yh{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let V2=0;const sf=new te,_o=new Lr,Di=new Ht,ia=new te,hr=new te,G2=new te,W2=new Lr,of=new te(1,0,0),rf=new te(0,1,0),af=new te(0,0,1),lf={type:"added"},$2={type:"removed"},vo={type:"childadded",child:null},Bl={type:"childremoved",child:null};class pn extends Ko{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:V2++}),this.uuid=Pr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=pn.DEFAULT_UP.clone();const e=new te,t=new Ti,n=new Lr,s=new te(1,1,1);function o(){n.setFromEuler(t,!1)}function r(){t.setFromQuaternion(n,void 0,!1)}t._onChange(o),n._onChange(r),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ht},normalMatrix:{value:new tt}}),this.matrix=new Ht,this.matrixWorld=new Ht,this.matrixAutoUpdate=pn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Yh,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.multiply(_o),this}rotateOnWorldAxis(e,t){return _o.setFromAxisAngle(e,t),this.quaternion.premultiply(_o),this}rotateX(e){return this.rotateOnAxis(of,e)}rotateY(e){return this.rotateOnAxis(rf,e)}rotateZ(e){return this.rotateOnAxis(af,e)}translateOnAxis(e,t){return sf.copy(e).applyQuaternion(this.quaternion),this.position.add(sf.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(of,e)}translateY(e){return this.translateOnAxis(rf,e)}translateZ(e){return this.translateOnAxis(af,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Di.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ia.copy(e):ia.set(e,t,n);const s=this.parent;this.updateWorldMatrix(!0,!1),hr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Di.lookAt(hr,ia,this.up):Di.lookAt(ia,hr,this.up),this.quaternion.setFromRotationMatrix(Di),s&&(Di.extractRotation(s.matrixWorld),_o.setFromRotationMatrix(Di),this.quaternion.premultiply(_o.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(lf),vo.child=e,this.dispatchEvent(vo),vo.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent($2),Bl.child=e,this.dispatchEvent(Bl),Bl.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Di.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Di.multiply(e.parent.matrixWorld)),e.applyMatrix4(Di),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(lf),vo.child=e,this.dispatchEvent(vo),vo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){const r=this.children[n].getObjectByProperty(e,t);if(r!==void 0)return r}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);const s=this.children;for(let o=0,r=s.length;o<r;o++)s[o].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(hr,e,G2),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(hr,W2,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t){const n=this.parent;if(e===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let o=0,r=s.length;o<r;o++)s[o].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function o(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=o(e.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const u=l[c];o(e.shapes,u)}else o(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(o(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(o(e.materials,this.material[l]));s.material=a}else s.material=o(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(o(e.animations,l))}}if(t){const a=r(e.geometries),l=r(e.materials),c=r(e.textures),h=r(e.images),u=r(e.shapes),d=r(e.skeletons),p=r(e.animations),g=r(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),p.length>0&&(n.animations=p),g.length>0&&(n.nodes=g)}return n.object=s,n;function r(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){const s=e.children[n];this.add(s.clone())}return this}}pn.DEFAULT_UP=new te(0,1,0);pn.DEFAULT_MATRIX_AUTO_UPDATE=!0;pn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const ii=new te,Ii=new te,Hl=new te,ki=new te,bo=new te,yo=new te,cf=new te,Vl=new te,Gl=new te,Wl=new te,$l=new Wt,ql=new Wt,Xl=new Wt;class li{constructor(e=new te,t=new te,n=new te){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ii.subVectors(e,t),s.cross(ii);const o=s.lengthSq();return o>0?s.multiplyScalar(1/Math.sqrt(o)):s.set(0,0,0)}static getBarycoord(e,t,n,s,o){ii.subVectors(s,t),Ii.subVectors(n,t),Hl.subVectors(e,t);const r=ii.dot(ii),a=ii.dot(Ii),l=ii.dot(Hl),c=Ii.dot(Ii),h=Ii.dot(Hl),u=r*c-a*a;if(u===0)return o.set(0,0,0),null;const d=1/u,p=(c*l-a*h)*d,g=(r*h-a*l)*d;return o.set(1-p-g,g,p)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ki)===null?!1:ki.x>=0&&ki.y>=0&&ki.x+ki.y<=1}static getInterpolation(e,t,n,s,o,r,a,l){return this.getBarycoord(e,t,n,s,ki)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(o,ki.x),l.addScaledVector(r,ki.y),l.addScaledVector(a,ki.z),l)}static getInterpolatedAttribute(e,t,n,s,o,r){return $l.setScalar(0),ql.setScalar(0),Xl.setScalar(0),$l.fromBufferAttribute(e,t),ql.fromBufferAttribute(e,n),Xl.fromBufferAttribute(e,s),r.setScalar(0),r.addScaledVector($l,o.x),r.addScaledVector(ql,o.y),r.addScaledVector(Xl,o.z),r}static isFrontFacing(e,t,n,s){return ii.subVectors(n,t),Ii.subVectors(e,t),ii.cross(Ii).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ii.subVectors(this.c,this.b),Ii.subVectors(this.a,this.b),ii.cross(Ii).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return li.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return li.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,o){return li.getInterpolation(e,this.a,this.b,this.c,t,n,s,o)}containsPoint(e){return li.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return li.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const n=this.a,s=this.b,o=this.c;let r,a;bo.subVectors(s,n),yo.subVectors(o,n),Vl.subVectors(e,n);const l=bo.dot(Vl),c=yo.dot(Vl);if(l<=0&&c<=0)return t.copy(n);Gl.subVectors(e,s);const h=bo.dot(Gl),u=yo.dot(Gl);if(h>=0&&u<=h)return t.copy(s);const d=l*u-h*c;if(d<=0&&l>=0&&h<=0)return r=l/(l-h),t.copy(n).addScaledVector(bo,r);Wl.subVectors(e,o);const p=bo.dot(Wl),g=yo.dot(Wl);if(g>=0&&p<=g)return t.copy(o);const _=p*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(yo,a);const m=h*g-p*u;if(m<=0&&u-h>=0&&p-g>=0)return cf.subVectors(o,s),a=(u-h)/(u-h+(p-g)),t.copy(s).addScaledVector(cf,a);const f=1/(m+_+d);return r=_*f,a=d*f,t.copy(n).addScaledVector(bo,r).addScaledVector(yo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}const Lm={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ns={h:0,s:0,l:0},sa={h:0,s:0,l:0};function jl(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}class ft{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=zn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,_t.toWorkingColorSpace(this,t),this}setRGB(e,t,n,s=_t.workingColorSpace){return this.r=e,this.g=t,this.b=n,_t.toWorkingColorSpace(this,s),this}setHSL(e,t,n,s=_t.workingColorSpace){if(e=C2(e,1),t=Pn(t,0,1),n=Pn(n,0,1),t===0)this.r=this.g=this.b=n;else{const o=n<=.5?n*(1+t):n+t-n*t,r=2*n-o;this.r=jl(r,o,e+1/3),this.g=jl(r,o,e),this.b=jl(r,o,e-1/3)}return _t.toWorkingColorSpace(this,s),this}setStyle(e,t=zn){function n(o){o!==void 0&&parseFloat(o)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let o;const r=s[1],a=s[2];switch(r){case"rgb":case"rgba":if(o=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setRGB(Math.min(255,parseInt(o[1],10))/255,Math.min(255,parseInt(o[2],10))/255,Math.min(255,parseInt(o[3],10))/255,t);if(o=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setRGB(Math.min(100,parseInt(o[1],10))/100,Math.min(100,parseInt(o[2],10))/100,Math.min(100,parseInt(o[3],10))/100,t);break;case"hsl":case"hsla":if(o=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(o[4]),this.setHSL(parseFloat(o[1])/360,parseFloat(o[2])/100,parseFloat(o[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const o=s[1],r=o.length;if(r===3)return this.setRGB(parseInt(o.charAt(0),16)/15,parseInt(o.charAt(1),16)/15,parseInt(o.charAt(2),16)/15,t);if(r===6)return this.setHex(parseInt(o,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=zn){const n=Lm[e.toLowerCase()];return n!==void 0?this.setHex(n,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Wi(e.r),this.g=Wi(e.g),this.b=Wi(e.b),this}copyLinearToSRGB(e){return this.r=Do(e.r),this.g=Do(e.g),this.b=Do(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=zn){return _t.fromWorkingColorSpace(vn.copy(this),e),Math.round(Pn(vn.r*255,0,255))*65536+Math.round(Pn(vn.g*255,0,255))*256+Math.round(Pn(vn.b*255,0,255))}getHexString(e=zn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=_t.workingColorSpace){_t.fromWorkingColorSpace(vn.copy(this),t);const n=vn.r,s=vn.g,o=vn.b,r=Math.max(n,s,o),a=Math.min(n,s,o);let l,c;const h=(a+r)/2;if(a===r)l=0,c=0;else{const u=r-a;switch(c=h<=.5?u/(r+a):u/(2-r-a),r){case n:l=(s-o)/u+(s<o?6:0);break;case s:l=(o-n)/u+2;break;case o:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=_t.workingColorSpace){return _t.fromWorkingColorSpace(vn.copy(this),t),e.r=vn.r,e.g=vn.g,e.b=vn.b,e}getStyle(e=zn){_t.fromWorkingColorSpace(vn.copy(this),e);const t=vn.r,n=vn.g,s=vn.b;return e!==zn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ns),this.setHSL(ns.h+e,ns.s+t,ns.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ns),e.getHSL(sa);const n=Ll(ns.h,sa.h,t),s=Ll(ns.s,sa.s,t),o=Ll(ns.l,sa.l,t);return this.setHSL(n,s,o),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,n=this.g,s=this.b,o=e.elements;return this.r=o[0]*t+o[3]*n+o[6]*s,this.g=o[1]*t+o[4]*n+o[7]*s,this.b=o[2]*t+o[5]*n+o[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const vn=new ft;ft.NAMES=Lm;let q2=0;class Dr extends Ko{static get type(){return"Material"}get type(){return this.constructor.type}set type(e){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:q2++}),this.uuid=Pr(),this.name="",this.blending=Lo,this.side=ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ec,this.blendDst=Tc,this.blendEquation=Us,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ft(0,0,0),this.blendAlpha=0,this.depthFunc=Oo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=$d,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ho,this.stencilZFail=ho,this.stencilZPass=ho,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const n=e[t];if(n===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Lo&&(n.blending=this.blending),this.side!==ms&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==Ec&&(n.blendSrc=this.blendSrc),this.blendDst!==Tc&&(n.blendDst=this.blendDst),this.blendEquation!==Us&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Oo&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==$d&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==ho&&(n.stencilFail=this.stencilFail),this.stencilZFail!==ho&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==ho&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(o){const r=[];for(const a in o){const l=o[a];delete l.metadata,r.push(l)}return r}if(t){const o=s(e.textures),r=s(e.images);o.length>0&&(n.textures=o),r.length>0&&(n.images=r)}return n}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let n=null;if(t!==null){const s=t.length;n=new Array(s);for(let o=0;o!==s;++o)n[o]=t[o].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class Kh extends Dr{static get type(){return"MeshBasicMaterial"}constructor(e){super(),this.isMeshBasicMaterial=!0,this.color=new ft(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ti,this.combine=fm,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Xt=new te,oa=new vt;class Si{constructor(e,t,n=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=qd,this.updateRanges=[],this.gpuType=zi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,o=this.itemSize;s<o;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)oa.fromBufferAttribute(this,t),oa.applyMatrix3(e),this.setXY(t,oa.x,oa.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix3(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyMatrix4(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.applyNormalMatrix(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Xt.fromBufferAttribute(this,t),Xt.transformDirection(e),this.setXYZ(t,Xt.x,Xt.y,Xt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=ar(n,this.array)),n}setComponent(e,t,n){return this.normalized&&(n=Cn(n,this.array)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=ar(t,this.array)),t}setX(e,t){return this.normalized&&(t=Cn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=ar(t,this.array)),t}setY(e,t){return this.normalized&&(t=Cn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=ar(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Cn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=ar(t,this.array)),t}setW(e,t){return this.normalized&&(t=Cn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=Cn(t,this.array),n=Cn(n,this.array)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=Cn(t,this.array),n=Cn(n,this.array),s=Cn(s,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,o){return e*=this.itemSize,this.normalized&&(t=Cn(t,this.array),n=Cn(n,this.array),s=Cn(s,this.array),o=Cn(o,this.array)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=o,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==qd&&(e.usage=this.usage),e}}class Nm extends Si{constructor(e,t,n){super(new Uint16Array(e),t,n)}}class Dm extends Si{constructor(e,t,n){super(new Uint32Array(e),t,n)}}class wi extends Si{constructor(e,t,n){super(new Float32Array(e),t,n)}}let X2=0;const $n=new Ht,Yl=new pn,xo=new te,Fn=new Nr,ur=new Nr,cn=new te;class _s extends Ko{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:X2++}),this.uuid=Pr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Am(e)?Dm:Nm)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const o=new tt().getNormalMatrix(e);n.applyNormalMatrix(o),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return $n.makeRotationFromQuaternion(e),this.applyMatrix4($n),this}rotateX(e){return $n.makeRotationX(e),this.applyMatrix4($n),this}rotateY(e){return $n.makeRotationY(e),this.applyMatrix4($n),this}rotateZ(e){return $n.makeRotationZ(e),this.applyMatrix4($n),this}translate(e,t,n){return $n.makeTranslation(e,t,n),this.applyMatrix4($n),this}scale(e,t,n){return $n.makeScale(e,t,n),this.applyMatrix4($n),this}lookAt(e){return Yl.lookAt(e),Yl.updateMatrix(),this.applyMatrix4(Yl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(xo).negate(),this.translate(xo.x,xo.y,xo.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const n=[];for(let s=0,o=e.length;s<o;s++){const r=e[s];n.push(r.x,r.y,r.z||0)}this.setAttribute("position",new wi(n,3))}else{for(let n=0,s=t.count;n<s;n++){const o=e[n];t.setXYZ(n,o.x,o.y,o.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Nr);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new te(-1/0,-1/0,-1/0),new te(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){const o=t[n];Fn.setFromBufferAttribute(o),this.morphTargetsRelative?(cn.addVectors(this.boundingBox.min,Fn.min),this.boundingBox.expandByPoint(cn),cn.addVectors(this.boundingBox.max,Fn.max),this.boundingBox.expandByPoint(cn)):(this.boundingBox.expandByPoint(Fn.min),this.boundingBox.expandByPoint(Fn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new jh);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new te,1/0);return}if(e){const n=this.boundingSphere.center;if(Fn.setFromBufferAttribute(e),t)for(let o=0,r=t.length;o<r;o++){const a=t[o];ur.setFromBufferAttribute(a),this.morphTargetsRelative?(cn.addVectors(Fn.min,ur.min),Fn.expandByPoint(cn),cn.addVectors(Fn.max,ur.max),Fn.expandByPoint(cn)):(Fn.expandByPoint(ur.min),Fn.expandByPoint(ur.max))}Fn.getCenter(n);let s=0;for(let o=0,r=e.count;o<r;o++)cn.fromBufferAttribute(e,o),s=Math.max(s,n.distanceToSquared(cn));if(t)for(let o=0,r=t.length;o<r;o++){const a=t[o],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)cn.fromBufferAttribute(a,c),l&&(xo.fromBufferAttribute(e,c),cn.add(xo)),s=Math.max(s,n.distanceToSquared(cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=t.position,s=t.normal,o=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Si(new Float32Array(4*n.count),4));const r=this.getAttribute("tangent"),a=[],l=[];for(let U=0;U<n.count;U++)a[U]=new te,l[U]=new te;const c=new te,h=new te,u=new te,d=new vt,p=new vt,g=new vt,_=new te,m=new te;function f(U,E,x){c.fromBufferAttribute(n,U),h.fromBufferAttribute(n,E),u.fromBufferAttribute(n,x),d.fromBufferAttribute(o,U),p.fromBufferAttribute(o,E),g.fromBufferAttribute(o,x),h.sub(c),u.sub(c),p.sub(d),g.sub(d);const C=1/(p.x*g.y-g.x*p.y);isFinite(C)&&(_.copy(h).multiplyScalar(g.y).addScaledVector(u,-p.y).multiplyScalar(C),m.copy(u).multiplyScalar(p.x).addScaledVector(h,-g.x).multiplyScalar(C),a[U].add(_),a[E].add(_),a[x].add(_),l[U].add(m),l[E].add(m),l[x].add(m))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let U=0,E=M.length;U<E;++U){const x=M[U],C=x.start,V=x.count;for(let O=C,q=C+V;O<q;O+=3)f(e.getX(O+0),e.getX(O+1),e.getX(O+2))}const S=new te,b=new te,F=new te,L=new te;function A(U){F.fromBufferAttribute(s,U),L.copy(F);const E=a[U];S.copy(E),S.sub(F.multiplyScalar(F.dot(E))).normalize(),b.crossVectors(L,E);const C=b.dot(l[U])<0?-1:1;r.setXYZW(U,S.x,S.y,S.z,C)}for(let U=0,E=M.length;U<E;++U){const x=M[U],C=x.start,V=x.count;for(let O=C,q=C+V;O<q;O+=3)A(e.getX(O+0)),A(e.getX(O+1)),A(e.getX(O+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new Si(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,p=n.count;d<p;d++)n.setXYZ(d,0,0,0);const s=new te,o=new te,r=new te,a=new te,l=new te,c=new te,h=new te,u=new te;if(e)for(let d=0,p=e.count;d<p;d+=3){const g=e.getX(d+0),_=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),o.fromBufferAttribute(t,_),r.fromBufferAttribute(t,m),h.subVectors(r,o),u.subVectors(s,o),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,p=t.count;d<p;d+=3)s.fromBufferAttribute(t,d+0),o.fromBufferAttribute(t,d+1),r.fromBufferAttribute(t,d+2),h.subVectors(r,o),u.subVectors(s,o),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)cn.fromBufferAttribute(e,t),cn.normalize(),e.setXYZ(t,cn.x,cn.y,cn.z)}toNonIndexed(){function e(a,l){const c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h);let p=0,g=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?p=l[_]*a.data.stride+a.offset:p=l[_]*h;for(let f=0;f<h;f++)d[g++]=c[p++]}return new Si(d,h,u)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new _s,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=e(l,n);t.setAttribute(a,c)}const o=this.morphAttributes;for(const a in o){const l=[],c=o[a];for(let h=0,u=c.length;h<u;h++){const d=c[h],p=e(d,n);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;const r=this.groups;for(let a=0,l=r.length;a<l;a++){const c=r[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){const e={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const n=this.attributes;for(const l in n){const c=n[l];e.data.attributes[l]=c.toJSON(e.data)}const s={};let o=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){const p=c[u];h.push(p.toJSON(e.data))}h.length>0&&(s[l]=h,o=!0)}o&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const r=this.groups;r.length>0&&(e.data.groups=JSON.parse(JSON.stringify(r)));const a=this.boundingSphere;return a!==null&&(e.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const n=e.index;n!==null&&this.setIndex(n.clone(t));const s=e.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(t))}const o=e.morphAttributes;for(const c in o){const h=[],u=o[c];for(let d=0,p=u.length;d<p;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;const r=e.groups;for(let c=0,h=r.length;c<h;c++){const u=r[c];this.addGroup(u.start,u.count,u.materialIndex)}const a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const hf=new Ht,Ts=new Pm,ra=new jh,uf=new te,aa=new te,la=new te,ca=new te,Kl=new te,ha=new te,df=new te,ua=new te;class dn extends pn{constructor(e=new _s,t=new Kh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){const s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let o=0,r=s.length;o<r;o++){const a=s[o].name||String(o);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=o}}}}getVertexPosition(e,t){const n=this.geometry,s=n.attributes.position,o=n.morphAttributes.position,r=n.morphTargetsRelative;t.fromBufferAttribute(s,e);const a=this.morphTargetInfluences;if(o&&a){ha.set(0,0,0);for(let l=0,c=o.length;l<c;l++){const h=a[l],u=o[l];h!==0&&(Kl.fromBufferAttribute(u,e),r?ha.addScaledVector(Kl,h):ha.addScaledVector(Kl.sub(t),h))}t.add(ha)}return t}raycast(e,t){const n=this.geometry,s=this.material,o=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ra.copy(n.boundingSphere),ra.applyMatrix4(o),Ts.copy(e.ray).recast(e.near),!(ra.containsPoint(Ts.origin)===!1&&(Ts.intersectSphere(ra,uf)===null||Ts.origin.distanceToSquared(uf)>(e.far-e.near)**2))&&(hf.copy(o).invert(),Ts.copy(e.ray).applyMatrix4(hf),!(n.boundingBox!==null&&Ts.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ts)))}_computeIntersections(e,t,n){let s;const o=this.geometry,r=this.material,a=o.index,l=o.attributes.position,c=o.attributes.uv,h=o.attributes.uv1,u=o.attributes.normal,d=o.groups,p=o.drawRange;if(a!==null)if(Array.isArray(r))for(let g=0,_=d.length;g<_;g++){const m=d[g],f=r[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let b=M,F=S;b<F;b+=3){const L=a.getX(b),A=a.getX(b+1),U=a.getX(b+2);s=da(this,f,e,n,c,h,u,L,A,U),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const g=Math.max(0,p.start),_=Math.min(a.count,p.start+p.count);for(let m=g,f=_;m<f;m+=3){const M=a.getX(m),S=a.getX(m+1),b=a.getX(m+2);s=da(this,r,e,n,c,h,u,M,S,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(r))for(let g=0,_=d.length;g<_;g++){const m=d[g],f=r[m.materialIndex],M=Math.max(m.start,p.start),S=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let b=M,F=S;b<F;b+=3){const L=b,A=b+1,U=b+2;s=da(this,f,e,n,c,h,u,L,A,U),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{const g=Math.max(0,p.start),_=Math.min(l.count,p.start+p.count);for(let m=g,f=_;m<f;m+=3){const M=m,S=m+1,b=m+2;s=da(this,r,e,n,c,h,u,M,S,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}}function j2(i,e,t,n,s,o,r,a){let l;if(e.side===Ln?l=n.intersectTriangle(r,o,s,!0,a):l=n.intersectTriangle(s,o,r,e.side===ms,a),l===null)return null;ua.copy(a),ua.applyMatrix4(i.matrixWorld);const c=t.ray.origin.distanceTo(ua);return c<t.near||c>t.far?null:{distance:c,point:ua.clone(),object:i}}function da(i,e,t,n,s,o,r,a,l,c){i.getVertexPosition(a,aa),i.getVertexPosition(l,la),i.getVertexPosition(c,ca);const h=j2(i,e,t,n,aa,la,ca,df);if(h){const u=new te;li.getBarycoord(df,aa,la,ca,u),s&&(h.uv=li.getInterpolatedAttribute(s,a,l,c,u,new vt)),o&&(h.uv1=li.getInterpolatedAttribute(o,a,l,c,u,new vt)),r&&(h.normal=li.getInterpolatedAttribute(r,a,l,c,u,new te),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const d={a,b:l,c,normal:new te,materialIndex:0};li.getNormal(aa,la,ca,d.normal),h.face=d,h.barycoord=u}return h}class Ys extends _s{constructor(e=1,t=1,n=1,s=1,o=1,r=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:o,depthSegments:r};const a=this;s=Math.floor(s),o=Math.floor(o),r=Math.floor(r);const l=[],c=[],h=[],u=[];let d=0,p=0;g("z","y","x",-1,-1,n,t,e,r,o,0),g("z","y","x",1,-1,n,t,-e,r,o,1),g("x","z","y",1,1,e,n,t,s,r,2),g("x","z","y",1,-1,e,n,-t,s,r,3),g("x","y","z",1,-1,e,t,n,s,o,4),g("x","y","z",-1,-1,e,t,-n,s,o,5),this.setIndex(l),this.setAttribute("position",new wi(c,3)),this.setAttribute("normal",new wi(h,3)),this.setAttribute("uv",new wi(u,2));function g(_,m,f,M,S,b,F,L,A,U,E){const x=b/A,C=F/U,V=b/2,O=F/2,q=L/2,$=A+1,X=U+1;let Y=0,ee=0;const ae=new te;for(let ce=0;ce<X;ce++){const _e=ce*C-O;for(let be=0;be<$;be++){const me=be*x-V;ae[_]=me*M,ae[m]=_e*S,ae[f]=q,c.push(ae.x,ae.y,ae.z),ae[_]=0,ae[m]=0,ae[f]=L>0?1:-1,h.push(ae.x,ae.y,ae.z),u.push(be/A),u.push(1-ce/U),Y+=1}}for(let ce=0;ce<U;ce++)for(let _e=0;_e<A;_e++){const be=d+_e+$*ce,me=d+_e+$*(ce+1),oe=d+(_e+1)+$*(ce+1),ue=d+(_e+1)+$*ce;l.push(be,me,ue),l.push(me,oe,ue),ee+=6}a.addGroup(p,ee,E),p+=ee,d+=Y}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Ys(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}function Go(i){const e={};for(const t in i){e[t]={};for(const n in i[t]){const s=i[t][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone():Array.isArray(s)?e[t][n]=s.slice():e[t][n]=s}}return e}function wn(i){const e={};for(let t=0;t<i.length;t++){const n=Go(i[t]);for(const s in n)e[s]=n[s]}return e}function Y2(i){const e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Im(i){const e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:_t.workingColorSpace}const K2={clone:Go,merge:wn};var Z2=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,J2=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class gs extends Dr{static get type(){return"ShaderMaterial"}constructor(e){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Z2,this.fragmentShader=J2,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Go(e.uniforms),this.uniformsGroups=Y2(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const r=this.uniforms[s].value;r&&r.isTexture?t.uniforms[s]={type:"t",value:r.toJSON(e).uuid}:r&&r.isColor?t.uniforms[s]={type:"c",value:r.getHex()}:r&&r.isVector2?t.uniforms[s]={type:"v2",value:r.toArray()}:r&&r.isVector3?t.uniforms[s]={type:"v3",value:r.toArray()}:r&&r.isVector4?t.uniforms[s]={type:"v4",value:r.toArray()}:r&&r.isMatrix3?t.uniforms[s]={type:"m3",value:r.toArray()}:r&&r.isMatrix4?t.uniforms[s]={type:"m4",value:r.toArray()}:t.uniforms[s]={value:r}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}}class km extends pn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ht,this.projectionMatrix=new Ht,this.projectionMatrixInverse=new Ht,this.coordinateSystem=Bi}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const is=new te,ff=new vt,pf=new vt;class Kn extends km{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=ch*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(Pl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ch*2*Math.atan(Math.tan(Pl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){is.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(is.x,is.y).multiplyScalar(-e/is.z),is.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(is.x,is.y).multiplyScalar(-e/is.z)}getViewSize(e,t){return this.getViewBounds(e,ff,pf),t.subVectors(pf,ff)}setViewOffset(e,t,n,s,o,r){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(Pl*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,o=-.5*s;const r=this.view;if(this.view!==null&&this.view.enabled){const l=r.fullWidth,c=r.fullHeight;o+=r.offsetX*s/l,t-=r.offsetY*n/c,s*=r.width/l,n*=r.height/c}const a=this.filmOffset;a!==0&&(o+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(o,o+s,t,t-n,e,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}const Mo=-90,So=1;class Q2 extends pn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Kn(Mo,So,e,t);s.layers=this.layers,this.add(s);const o=new Kn(Mo,So,e,t);o.layers=this.layers,this.add(o);const r=new Kn(Mo,So,e,t);r.layers=this.layers,this.add(r);const a=new Kn(Mo,So,e,t);a.layers=this.layers,this.add(a);const l=new Kn(Mo,So,e,t);l.layers=this.layers,this.add(l);const c=new Kn(Mo,So,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[n,s,o,r,a,l]=t;for(const c of t)this.remove(c);if(e===Bi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),o.up.set(0,0,-1),o.lookAt(0,1,0),r.up.set(0,0,1),r.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Va)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),o.up.set(0,0,1),o.lookAt(0,1,0),r.up.set(0,0,-1),r.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[o,r,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;const _=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,e.setRenderTarget(n,0,s),e.render(t,o),e.setRenderTarget(n,1,s),e.render(t,r),e.setRenderTarget(n,2,s),e.render(t,a),e.setRenderTarget(n,3,s),e.render(t,l),e.setRenderTarget(n,4,s),e.render(t,c),n.texture.generateMipmaps=_,e.setRenderTarget(n,5,s),e.render(t,h),e.setRenderTarget(u,d,p),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}}class Um extends Tn{constructor(e,t,n,s,o,r,a,l,c,h){e=e!==void 0?e:[],t=t!==void 0?t:zo,super(e,t,n,s,o,r,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class eP extends js{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Um(s,t.mapping,t.wrapS,t.wrapT,t.magFilter,t.minFilter,t.format,t.type,t.anisotropy,t.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=t.generateMipmaps!==void 0?t.generateMipmaps:!1,this.texture.minFilter=t.minFilter!==void 0?t.minFilter:xi}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ys(5,5,5),o=new gs({name:"CubemapFromEquirect",uniforms:Go(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ln,blending:hs});o.uniforms.tEquirect.value=t;const r=new dn(s,o),a=t.minFilter;return t.minFilter===zs&&(t.minFilter=xi),new Q2(1,10,this).update(e,r),t.minFilter=a,r.geometry.dispose(),r.material.dispose(),this}clear(e,t,n,s){const o=e.getRenderTarget();for(let r=0;r<6;r++)e.setRenderTarget(this,r),e.clear(t,n,s);e.setRenderTarget(o)}}const Zl=new te,tP=new te,nP=new tt;class rs{constructor(e=new te(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){const s=Zl.subVectors(n,t).cross(tP.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){const n=e.delta(Zl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const o=-(e.start.dot(this.normal)+this.constant)/s;return o<0||o>1?null:t.copy(e.start).addScaledVector(n,o)}intersectsLine(e){const t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const n=t||nP.getNormalMatrix(e),s=this.coplanarPoint(Zl).applyMatrix4(e),o=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(o),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const As=new jh,fa=new te;class Zh{constructor(e=new rs,t=new rs,n=new rs,s=new rs,o=new rs,r=new rs){this.planes=[e,t,n,s,o,r]}set(e,t,n,s,o,r){const a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(o),a[5].copy(r),this}copy(e){const t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Bi){const n=this.planes,s=e.elements,o=s[0],r=s[1],a=s[2],l=s[3],c=s[4],h=s[5],u=s[6],d=s[7],p=s[8],g=s[9],_=s[10],m=s[11],f=s[12],M=s[13],S=s[14],b=s[15];if(n[0].setComponents(l-o,d-c,m-p,b-f).normalize(),n[1].setComponents(l+o,d+c,m+p,b+f).normalize(),n[2].setComponents(l+r,d+h,m+g,b+M).normalize(),n[3].setComponents(l-r,d-h,m-g,b-M).normalize(),n[4].setComponents(l-a,d-u,m-_,b-S).normalize(),t===Bi)n[5].setComponents(l+a,d+u,m+_,b+S).normalize();else if(t===Va)n[5].setComponents(a,u,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),As.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),As.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(As)}intersectsSprite(e){return As.center.set(0,0,0),As.radius=.7071067811865476,As.applyMatrix4(e.matrixWorld),this.intersectsSphere(As)}intersectsSphere(e){const t=this.planes,n=e.center,s=-e.radius;for(let o=0;o<6;o++)if(t[o].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let n=0;n<6;n++){const s=t[n];if(fa.x=s.normal.x>0?e.max.x:e.min.x,fa.y=s.normal.y>0?e.max.y:e.min.y,fa.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(fa)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Fm(){let i=null,e=!1,t=null,n=null;function s(o,r){t(o,r),n=i.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(o){t=o},setContext:function(o){i=o}}}function iP(i){const e=new WeakMap;function t(a,l){const c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){const h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((p,g)=>p.start-g.start);let d=0;for(let p=1;p<u.length;p++){const g=u[d],_=u[p];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++d,u[d]=_)}u.length=d+1;for(let p=0,g=u.length;p<g;p++){const _=u[p];i.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function o(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function r(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:o,update:r}}class Ir extends _s{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};const o=e/2,r=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,p=[],g=[],_=[],m=[];for(let f=0;f<h;f++){const M=f*d-r;for(let S=0;S<c;S++){const b=S*u-o;g.push(b,-M,0),_.push(0,0,1),m.push(S/a),m.push(1-f/l)}}for(let f=0;f<l;f++)for(let M=0;M<a;M++){const S=M+c*f,b=M+c*(f+1),F=M+1+c*(f+1),L=M+1+c*f;p.push(S,b,L),p.push(b,F,L)}this.setIndex(p),this.setAttribute("position",new wi(g,3)),this.setAttribute("normal",new wi(_,3)),this.setAttribute("uv",new wi(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Ir(e.width,e.height,e.widthSegments,e.heightSegments)}}var sP=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,oP=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,rP=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,aP=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,lP=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,cP=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,hP=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,uP=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,dP=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,fP=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,pP=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,mP=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,gP=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,_P=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,vP=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,bP=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,yP=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,xP=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,MP=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,SP=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,wP=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,EP=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,TP=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,AP=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,RP=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,CP=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,PP=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,LP=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,NP=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,DP=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,IP="gl_FragColor = linearToOutputTexel( gl_FragColor );",kP=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,UP=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,FP=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,OP=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,zP=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,BP=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,HP=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,VP=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,GP=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,WP=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,$P=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,qP=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,XP=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,jP=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,YP=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,KP=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,ZP=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,JP=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,QP=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,eL=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,tL=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,nL=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,iL=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,sL=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,oL=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,rL=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,aL=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,lL=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,cL=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,hL=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,uL=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,dL=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,fL=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,pL=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,mL=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,gL=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,_L=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,vL=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,bL=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,yL=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,xL=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,ML=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,SL=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wL=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,EL=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,TL=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,AL=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,RL=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,CL=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,PL=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,LL=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,NL=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,DL=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,IL=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,kL=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,UL=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,FL=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,OL=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,zL=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,BL=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,HL=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,VL=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,GL=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,WL=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,$L=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,qL=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,XL=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,jL=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,YL=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,KL=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ZL=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,JL=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,QL=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,eN=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,tN=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,nN=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const iN=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,sN=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,oN=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,rN=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aN=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,lN=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,cN=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,hN=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,uN=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,dN=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,fN=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,pN=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mN=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,gN=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,_N=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,vN=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bN=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yN=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xN=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,MN=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,SN=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,wN=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,EN=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,TN=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,AN=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,RN=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,CN=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,PN=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,LN=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,NN=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,DN=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,IN=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,kN=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,UN=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,it={alphahash_fragment:sP,alphahash_pars_fragment:oP,alphamap_fragment:rP,alphamap_pars_fragment:aP,alphatest_fragment:lP,alphatest_pars_fragment:cP,aomap_fragment:hP,aomap_pars_fragment:uP,batching_pars_vertex:dP,batching_vertex:fP,begin_vertex:pP,beginnormal_vertex:mP,bsdfs:gP,iridescence_fragment:_P,bumpmap_pars_fragment:vP,clipping_planes_fragment:bP,clipping_planes_pars_fragment:yP,clipping_planes_pars_vertex:xP,clipping_planes_vertex:MP,color_fragment:SP,color_pars_fragment:wP,color_pars_vertex:EP,color_vertex:TP,common:AP,cube_uv_reflection_fragment:RP,defaultnormal_vertex:CP,displacementmap_pars_vertex:PP,displacementmap_vertex:LP,emissivemap_fragment:NP,emissivemap_pars_fragment:DP,colorspace_fragment:IP,colorspace_pars_fragment:kP,envmap_fragment:UP,envmap_common_pars_fragment:FP,envmap_pars_fragment:OP,envmap_pars_vertex:zP,envmap_physical_pars_fragment:KP,envmap_vertex:BP,fog_vertex:HP,fog_pars_vertex:VP,fog_fragment:GP,fog_pars_fragment:WP,gradientmap_pars_fragment:$P,lightmap_pars_fragment:qP,lights_lambert_fragment:XP,lights_lambert_pars_fragment:jP,lights_pars_begin:YP,lights_toon_fragment:ZP,lights_toon_pars_fragment:JP,lights_phong_fragment:QP,lights_phong_pars_fragment:eL,lights_physical_fragment:tL,lights_physical_pars_fragment:nL,lights_fragment_begin:iL,lights_fragment_maps:sL,lights_fragment_end:oL,logdepthbuf_fragment:rL,logdepthbuf_pars_fragment:aL,logdepthbuf_pars_vertex:lL,logdepthbuf_vertex:cL,map_fragment:hL,map_pars_fragment:uL,map_particle_fragment:dL,map_particle_pars_fragment:fL,metalnessmap_fragment:pL,metalnessmap_pars_fragment:mL,morphinstance_vertex:gL,morphcolor_vertex:_L,morphnormal_vertex:vL,morphtarget_pars_vertex:bL,morphtarget_vertex:yL,normal_fragment_begin:xL,normal_fragment_maps:ML,normal_pars_fragment:SL,normal_pars_vertex:wL,normal_vertex:EL,normalmap_pars_fragment:TL,clearcoat_normal_fragment_begin:AL,clearcoat_normal_fragment_maps:RL,clearcoat_pars_fragment:CL,iridescence_pars_fragment:PL,opaque_fragment:LL,packing:NL,premultiplied_alpha_fragment:DL,project_vertex:IL,dithering_fragment:kL,dithering_pars_fragment:UL,roughnessmap_fragment:FL,roughnessmap_pars_fragment:OL,shadowmap_pars_fragment:zL,shadowmap_pars_vertex:BL,shadowmap_vertex:HL,shadowmask_pars_fragment:VL,skinbase_vertex:GL,skinning_pars_vertex:WL,skinning_vertex:$L,skinnormal_vertex:qL,specularmap_fragment:XL,specularmap_pars_fragment:jL,tonemapping_fragment:YL,tonemapping_pars_fragment:KL,transmission_fragment:ZL,transmission_pars_fragment:JL,uv_pars_fragment:QL,uv_pars_vertex:eN,uv_vertex:tN,worldpos_vertex:nN,background_vert:iN,background_frag:sN,backgroundCube_vert:oN,backgroundCube_frag:rN,cube_vert:aN,cube_frag:lN,depth_vert:cN,depth_frag:hN,distanceRGBA_vert:uN,distanceRGBA_frag:dN,equirect_vert:fN,equirect_frag:pN,linedashed_vert:mN,linedashed_frag:gN,meshbasic_vert:_N,meshbasic_frag:vN,meshlambert_vert:bN,meshlambert_frag:yN,meshmatcap_vert:xN,meshmatcap_frag:MN,meshnormal_vert:SN,meshnormal_frag:wN,meshphong_vert:EN,meshphong_frag:TN,meshphysical_vert:AN,meshphysical_frag:RN,meshtoon_vert:CN,meshtoon_frag:PN,points_vert:LN,points_frag:NN,shadow_vert:DN,shadow_frag:IN,sprite_vert:kN,sprite_frag:UN},Te={common:{diffuse:{value:new ft(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new tt}},envmap:{envMap:{value:null},envMapRotation:{value:new tt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new tt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new tt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new tt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new tt},normalScale:{value:new vt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new tt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new tt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new tt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new tt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ft(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ft(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0},uvTransform:{value:new tt}},sprite:{diffuse:{value:new ft(16777215)},opacity:{value:1},center:{value:new vt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new tt},alphaMap:{value:null},alphaMapTransform:{value:new tt},alphaTest:{value:0}}},bi={basic:{uniforms:wn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.fog]),vertexShader:it.meshbasic_vert,fragmentShader:it.meshbasic_frag},lambert:{uniforms:wn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new ft(0)}}]),vertexShader:it.meshlambert_vert,fragmentShader:it.meshlambert_frag},phong:{uniforms:wn([Te.common,Te.specularmap,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,Te.lights,{emissive:{value:new ft(0)},specular:{value:new ft(1118481)},shininess:{value:30}}]),vertexShader:it.meshphong_vert,fragmentShader:it.meshphong_frag},standard:{uniforms:wn([Te.common,Te.envmap,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.roughnessmap,Te.metalnessmap,Te.fog,Te.lights,{emissive:{value:new ft(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag},toon:{uniforms:wn([Te.common,Te.aomap,Te.lightmap,Te.emissivemap,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.gradientmap,Te.fog,Te.lights,{emissive:{value:new ft(0)}}]),vertexShader:it.meshtoon_vert,fragmentShader:it.meshtoon_frag},matcap:{uniforms:wn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,Te.fog,{matcap:{value:null}}]),vertexShader:it.meshmatcap_vert,fragmentShader:it.meshmatcap_frag},points:{uniforms:wn([Te.points,Te.fog]),vertexShader:it.points_vert,fragmentShader:it.points_frag},dashed:{uniforms:wn([Te.common,Te.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:it.linedashed_vert,fragmentShader:it.linedashed_frag},depth:{uniforms:wn([Te.common,Te.displacementmap]),vertexShader:it.depth_vert,fragmentShader:it.depth_frag},normal:{uniforms:wn([Te.common,Te.bumpmap,Te.normalmap,Te.displacementmap,{opacity:{value:1}}]),vertexShader:it.meshnormal_vert,fragmentShader:it.meshnormal_frag},sprite:{uniforms:wn([Te.sprite,Te.fog]),vertexShader:it.sprite_vert,fragmentShader:it.sprite_frag},background:{uniforms:{uvTransform:{value:new tt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:it.background_vert,fragmentShader:it.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new tt}},vertexShader:it.backgroundCube_vert,fragmentShader:it.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:it.cube_vert,fragmentShader:it.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:it.equirect_vert,fragmentShader:it.equirect_frag},distanceRGBA:{uniforms:wn([Te.common,Te.displacementmap,{referencePosition:{value:new te},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:it.distanceRGBA_vert,fragmentShader:it.distanceRGBA_frag},shadow:{uniforms:wn([Te.lights,Te.fog,{color:{value:new ft(0)},opacity:{value:1}}]),vertexShader:it.shadow_vert,fragmentShader:it.shadow_frag}};bi.physical={uniforms:wn([bi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new tt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new tt},clearcoatNormalScale:{value:new vt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new tt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new tt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new tt},sheen:{value:0},sheenColor:{value:new ft(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new tt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new tt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new tt},transmissionSamplerSize:{value:new vt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new tt},attenuationDistance:{value:0},attenuationColor:{value:new ft(0)},specularColor:{value:new ft(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new tt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new tt},anisotropyVector:{value:new vt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new tt}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag};const pa={r:0,b:0,g:0},Rs=new Ti,FN=new Ht;function ON(i,e,t,n,s,o,r){const a=new ft(0);let l=o===!0?0:1,c,h,u=null,d=0,p=null;function g(M){let S=M.isScene===!0?M.background:null;return S&&S.isTexture&&(S=(M.backgroundBlurriness>0?t:e).get(S)),S}function _(M){let S=!1;const b=g(M);b===null?f(a,l):b&&b.isColor&&(f(b,1),S=!0);const F=i.xr.getEnvironmentBlendMode();F==="additive"?n.buffers.color.setClear(0,0,0,1,r):F==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(M,S){const b=g(S);b&&(b.isCubeTexture||b.mapping===tl)?(h===void 0&&(h=new dn(new Ys(1,1,1),new gs({name:"BackgroundCubeMaterial",uniforms:Go(bi.backgroundCube.uniforms),vertexShader:bi.backgroundCube.vertexShader,fragmentShader:bi.backgroundCube.fragmentShader,side:Ln,depthTest:!1,depthWrite:!1,fog:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(F,L,A){this.matrixWorld.copyPosition(A.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(h)),Rs.copy(S.backgroundRotation),Rs.x*=-1,Rs.y*=-1,Rs.z*=-1,b.isCubeTexture&&b.isRenderTargetTexture===!1&&(Rs.y*=-1,Rs.z*=-1),h.material.uniforms.envMap.value=b,h.material.uniforms.flipEnvMap.value=b.isCubeTexture&&b.isRenderTargetTexture===!1?-1:1,h.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(FN.makeRotationFromEuler(Rs)),h.material.toneMapped=_t.getTransfer(b.colorSpace)!==Rt,(u!==b||d!==b.version||p!==i.toneMapping)&&(h.material.needsUpdate=!0,u=b,d=b.version,p=i.toneMapping),h.layers.enableAll(),M.unshift(h,h.geometry,h.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new dn(new Ir(2,2),new gs({name:"BackgroundMaterial",uniforms:Go(bi.background.uniforms),vertexShader:bi.background.vertexShader,fragmentShader:bi.background.fragmentShader,side:ms,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=_t.getTransfer(b.colorSpace)!==Rt,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,p=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null))}function f(M,S){M.getRGB(pa,Im(i)),n.buffers.color.setClear(pa.r,pa.g,pa.b,S,r)}return{getClearColor:function(){return a},setClearColor:function(M,S=1){a.set(M),l=S,f(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(M){l=M,f(a,l)},render:_,addToRenderList:m}}function zN(i,e){const t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null);let o=s,r=!1;function a(x,C,V,O,q){let $=!1;const X=u(O,V,C);o!==X&&(o=X,c(o.object)),$=p(x,O,V,q),$&&g(x,O,V,q),q!==null&&e.update(q,i.ELEMENT_ARRAY_BUFFER),($||r)&&(r=!1,b(x,C,V,O),q!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(q).buffer))}function l(){return i.createVertexArray()}function c(x){return i.bindVertexArray(x)}function h(x){return i.deleteVertexArray(x)}function u(x,C,V){const O=V.wireframe===!0;let q=n[x.id];q===void 0&&(q={},n[x.id]=q);let $=q[C.id];$===void 0&&($={},q[C.id]=$);let X=$[O];return X===void 0&&(X=d(l()),$[O]=X),X}function d(x){const C=[],V=[],O=[];for(let q=0;q<t;q++)C[q]=0,V[q]=0,O[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:V,attributeDivisors:O,object:x,attributes:{},index:null}}function p(x,C,V,O){const q=o.attributes,$=C.attributes;let X=0;const Y=V.getAttributes();for(const ee in Y)if(Y[ee].location>=0){const ce=q[ee];let _e=$[ee];if(_e===void 0&&(ee==="instanceMatrix"&&x.instanceMatrix&&(_e=x.instanceMatrix),ee==="instanceColor"&&x.instanceColor&&(_e=x.instanceColor)),ce===void 0||ce.attribute!==_e||_e&&ce.data!==_e.data)return!0;X++}return o.attributesNum!==X||o.index!==O}function g(x,C,V,O){const q={},$=C.attributes;let X=0;const Y=V.getAttributes();for(const ee in Y)if(Y[ee].location>=0){let ce=$[ee];ce===void 0&&(ee==="instanceMatrix"&&x.instanceMatrix&&(ce=x.instanceMatrix),ee==="instanceColor"&&x.instanceColor&&(ce=x.instanceColor));const _e={};_e.attribute=ce,ce&&ce.data&&(_e.data=ce.data),q[ee]=_e,X++}o.attributes=q,o.attributesNum=X,o.index=O}function _(){const x=o.newAttributes;for(let C=0,V=x.length;C<V;C++)x[C]=0}function m(x){f(x,0)}function f(x,C){const V=o.newAttributes,O=o.enabledAttributes,q=o.attributeDivisors;V[x]=1,O[x]===0&&(i.enableVertexAttribArray(x),O[x]=1),q[x]!==C&&(i.vertexAttribDivisor(x,C),q[x]=C)}function M(){const x=o.newAttributes,C=o.enabledAttributes;for(let V=0,O=C.length;V<O;V++)C[V]!==x[V]&&(i.disableVertexAttribArray(V),C[V]=0)}function S(x,C,V,O,q,$,X){X===!0?i.vertexAttribIPointer(x,C,V,q,$):i.vertexAttribPointer(x,C,V,O,q,$)}function b(x,C,V,O){_();const q=O.attributes,$=V.getAttributes(),X=C.defaultAttributeValues;for(const Y in $){const ee=$[Y];if(ee.location>=0){let ae=q[Y];if(ae===void 0&&(Y==="instanceMatrix"&&x.instanceMatrix&&(ae=x.instanceMatrix),Y==="instanceColor"&&x.instanceColor&&(ae=x.instanceColor)),ae!==void 0){const ce=ae.normalized,_e=ae.itemSize,be=e.get(ae);if(be===void 0)continue;const me=be.buffer,oe=be.type,ue=be.bytesPerElement,ve=oe===i.INT||oe===i.UNSIGNED_INT||ae.gpuType===Vh;if(ae.isInterleavedBufferAttribute){const he=ae.data,Ie=he.stride,Be=ae.offset;if(he.isInstancedInterleavedBuffer){for(let ke=0;ke<ee.locationSize;ke++)f(ee.location+ke,he.meshPerAttribute);x.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=he.meshPerAttribute*he.count)}else for(let ke=0;ke<ee.locationSize;ke++)m(ee.location+ke);i.bindBuffer(i.ARRAY_BUFFER,me);for(let ke=0;ke<ee.locationSize;ke++)S(ee.location+ke,_e/ee.locationSize,oe,ce,Ie*ue,(Be+_e/ee.locationSize*ke)*ue,ve)}else{if(ae.isInstancedBufferAttribute){for(let he=0;he<ee.locationSize;he++)f(ee.location+he,ae.meshPerAttribute);x.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let he=0;he<ee.locationSize;he++)m(ee.location+he);i.bindBuffer(i.ARRAY_BUFFER,me);for(let he=0;he<ee.locationSize;he++)S(ee.location+he,_e/ee.locationSize,oe,ce,_e*ue,_e/ee.locationSize*he*ue,ve)}}else if(X!==void 0){const ce=X[Y];if(ce!==void 0)switch(ce.length){case 2:i.vertexAttrib2fv(ee.location,ce);break;case 3:i.vertexAttrib3fv(ee.location,ce);break;case 4:i.vertexAttrib4fv(ee.location,ce);break;default:i.vertexAttrib1fv(ee.location,ce)}}}}M()}function F(){U();for(const x in n){const C=n[x];for(const V in C){const O=C[V];for(const q in O)h(O[q].object),delete O[q];delete C[V]}delete n[x]}}function L(x){if(n[x.id]===void 0)return;const C=n[x.id];for(const V in C){const O=C[V];for(const q in O)h(O[q].object),delete O[q];delete C[V]}delete n[x.id]}function A(x){for(const C in n){const V=n[C];if(V[x.id]===void 0)continue;const O=V[x.id];for(const q in O)h(O[q].object),delete O[q];delete V[x.id]}}function U(){E(),r=!0,o!==s&&(o=s,c(o.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:E,dispose:F,releaseStatesOfGeometry:L,releaseStatesOfProgram:A,initAttributes:_,enableAttribute:m,disableUnusedAttributes:M}}function BN(i,e,t){let n;function s(c){n=c}function o(c,h){i.drawArrays(n,c,h),t.update(h,n,1)}function r(c,h,u){u!==0&&(i.drawArraysInstanced(n,c,h,u),t.update(h,n,u))}function a(c,h,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,h,0,u);let p=0;for(let g=0;g<u;g++)p+=h[g];t.update(p,n,1)}function l(c,h,u,d){if(u===0)return;const p=e.get("WEBGL_multi_draw");if(p===null)for(let g=0;g<c.length;g++)r(c[g],h[g],d[g]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,h,0,d,0,u);let g=0;for(let _=0;_<u;_++)g+=h[_]*d[_];t.update(g,n,1)}}this.setMode=s,this.render=o,this.renderInstances=r,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function HN(i,e,t,n){let s;function o(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const A=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(A.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function r(A){return!(A!==ci&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(A){const U=A===Cr&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(A!==qi&&n.convert(A)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&A!==zi&&!U)}function l(A){if(A==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";A="mediump"}return A==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp";const h=l(c);h!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const u=t.logarithmicDepthBuffer===!0,d=t.reverseDepthBuffer===!0&&e.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),F=g>0,L=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:o,getMaxPrecision:l,textureFormatReadable:r,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reverseDepthBuffer:d,maxTextures:p,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:f,maxVertexUniforms:M,maxVaryings:S,maxFragmentUniforms:b,vertexTextures:F,maxSamples:L}}function VN(i){const e=this;let t=null,n=0,s=!1,o=!1;const r=new rs,a=new tt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){const p=u.length!==0||d||n!==0||s;return s=d,n=u.length,p},this.beginShadows=function(){o=!0,h(null)},this.endShadows=function(){o=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,p){const g=u.clippingPlanes,_=u.clipIntersection,m=u.clipShadows,f=i.get(u);if(!s||g===null||g.length===0||o&&!m)o?h(null):c();else{const M=o?0:n,S=M*4;let b=f.clippingState||null;l.value=b,b=h(g,d,S,p);for(let F=0;F!==S;++F)b[F]=t[F];f.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,p,g){const _=u!==null?u.length:0;let m=null;if(_!==0){if(m=l.value,g!==!0||m===null){const f=p+_*4,M=d.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<f)&&(m=new Float32Array(f));for(let S=0,b=p;S!==_;++S,b+=4)r.copy(u[S]).applyMatrix4(M,a),r.normal.toArray(m,b),m[b+3]=r.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,m}}function GN(i){let e=new WeakMap;function t(r,a){return a===Ic?r.mapping=zo:a===kc&&(r.mapping=Bo),r}function n(r){if(r&&r.isTexture){const a=r.mapping;if(a===Ic||a===kc)if(e.has(r)){const l=e.get(r).texture;return t(l,r.mapping)}else{const l=r.image;if(l&&l.height>0){const c=new eP(l.height);return c.fromEquirectangularTexture(i,r),e.set(r,c),r.addEventListener("dispose",s),t(c.texture,r.mapping)}else return null}}return r}function s(r){const a=r.target;a.removeEventListener("dispose",s);const l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function o(){e=new WeakMap}return{get:n,dispose:o}}class Om extends km{constructor(e=-1,t=1,n=1,s=-1,o=.1,r=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=o,this.far=r,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,o,r){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=o,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let o=n-e,r=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;o+=c*this.view.offsetX,r=o+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(o,r,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}const Co=4,mf=[.125,.215,.35,.446,.526,.582],Fs=20,Jl=new Om,gf=new ft;let Ql=null,ec=0,tc=0,nc=!1;const Ds=(1+Math.sqrt(5))/2,wo=1/Ds,_f=[new te(-Ds,wo,0),new te(Ds,wo,0),new te(-wo,0,Ds),new te(wo,0,Ds),new te(0,Ds,-wo),new te(0,Ds,wo),new te(-1,1,-1),new te(1,1,-1),new te(-1,1,1),new te(1,1,1)];class vf{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,n=.1,s=100){Ql=this._renderer.getRenderTarget(),ec=this._renderer.getActiveCubeFace(),tc=this._renderer.getActiveMipmapLevel(),nc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const o=this._allocateTargets();return o.depthBuffer=!0,this._sceneToCubeUV(e,n,s,o),t>0&&this._blur(o,0,0,t),this._applyPMREM(o),this._cleanup(o),o}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=xf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=yf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(Ql,ec,tc),this._renderer.xr.enabled=nc,e.scissorTest=!1,ma(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===zo||e.mapping===Bo?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),Ql=this._renderer.getRenderTarget(),ec=this._renderer.getActiveCubeFace(),tc=this._renderer.getActiveMipmapLevel(),nc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=t||this._allocateTargets();return this._textureToCubeUV(e,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,n={magFilter:xi,minFilter:xi,generateMipmaps:!1,type:Cr,format:ci,colorSpace:Yo,depthBuffer:!1},s=bf(e,t,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=bf(e,t,n);const{_lodMax:o}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=WN(o)),this._blurMaterial=$N(o,e,t)}return s}_compileMaterial(e){const t=new dn(this._lodPlanes[0],e);this._renderer.compile(t,Jl)}_sceneToCubeUV(e,t,n,s){const a=new Kn(90,1,t,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],h=this._renderer,u=h.autoClear,d=h.toneMapping;h.getClearColor(gf),h.toneMapping=us,h.autoClear=!1;const p=new Kh({name:"PMREM.Background",side:Ln,depthWrite:!1,depthTest:!1}),g=new dn(new Ys,p);let _=!1;const m=e.background;m?m.isColor&&(p.color.copy(m),e.background=null,_=!0):(p.color.copy(gf),_=!0);for(let f=0;f<6;f++){const M=f%3;M===0?(a.up.set(0,l[f],0),a.lookAt(c[f],0,0)):M===1?(a.up.set(0,0,l[f]),a.lookAt(0,c[f],0)):(a.up.set(0,l[f],0),a.lookAt(0,0,c[f]));const S=this._cubeSize;ma(s,M*S,f>2?S:0,S,S),h.setRenderTarget(s),_&&h.render(g,a),h.render(e,a)}g.geometry.dispose(),g.material.dispose(),h.toneMapping=d,h.autoClear=u,e.background=m}_textureToCubeUV(e,t){const n=this._renderer,s=e.mapping===zo||e.mapping===Bo;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=xf()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=yf());const o=s?this._cubemapMaterial:this._equirectMaterial,r=new dn(this._lodPlanes[0],o),a=o.uniforms;a.envMap.value=e;const l=this._cubeSize;ma(t,0,0,3*l,2*l),n.setRenderTarget(t),n.render(r,Jl)}_applyPMREM(e){const t=this._renderer,n=t.autoClear;t.autoClear=!1;const s=this._lodPlanes.length;for(let o=1;o<s;o++){const r=Math.sqrt(this._sigmas[o]*this._sigmas[o]-this._sigmas[o-1]*this._sigmas[o-1]),a=_f[(s-o-1)%_f.length];this._blur(e,o-1,o,r,a)}t.autoClear=n}_blur(e,t,n,s,o){const r=this._pingPongRenderTarget;this._halfBlur(e,r,t,n,s,"latitudinal",o),this._halfBlur(r,e,n,n,s,"longitudinal",o)}_halfBlur(e,t,n,s,o,r,a){const l=this._renderer,c=this._blurMaterial;r!=="latitudinal"&&r!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const h=3,u=new dn(this._lodPlanes[s],c),d=c.uniforms,p=this._sizeLods[n]-1,g=isFinite(o)?Math.PI/(2*p):2*Math.PI/(2*Fs-1),_=o/g,m=isFinite(o)?1+Math.floor(h*_):Fs;m>Fs&&console.warn(`sigmaRadians, ${o}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Fs}`);const f=[];let M=0;for(let A=0;A<Fs;++A){const U=A/_,E=Math.exp(-U*U/2);f.push(E),A===0?M+=E:A<m&&(M+=2*E)}for(let A=0;A<f.length;A++)f[A]=f[A]/M;d.envMap.value=e.texture,d.samples.value=m,d.weights.value=f,d.latitudinal.value=r==="latitudinal",a&&(d.poleAxis.value=a);const{_lodMax:S}=this;d.dTheta.value=g,d.mipInt.value=S-n;const b=this._sizeLods[s],F=3*b*(s>S-Co?s-S+Co:0),L=4*(this._cubeSize-b);ma(t,F,L,3*b,2*b),l.setRenderTarget(t),l.render(u,Jl)}}function WN(i){const e=[],t=[],n=[];let s=i;const o=i-Co+1+mf.length;for(let r=0;r<o;r++){const a=Math.pow(2,s);t.push(a);let l=1/a;r>i-Co?l=mf[r-i+Co-1]:r===0&&(l=0),n.push(l);const c=1/(a-2),h=-c,u=1+c,d=[h,h,u,h,u,u,h,h,u,u,h,u],p=6,g=6,_=3,m=2,f=1,M=new Float32Array(_*g*p),S=new Float32Array(m*g*p),b=new Float32Array(f*g*p);for(let L=0;L<p;L++){const A=L%3*2/3-1,U=L>2?0:-1,E=[A,U,0,A+2/3,U,0,A+2/3,U+1,0,A,U,0,A+2/3,U+1,0,A,U+1,0];M.set(E,_*g*L),S.set(d,m*g*L);const x=[L,L,L,L,L,L];b.set(x,f*g*L)}const F=new _s;F.setAttribute("position",new Si(M,_)),F.setAttribute("uv",new Si(S,m)),F.setAttribute("faceIndex",new Si(b,f)),e.push(F),s>Co&&s--}return{lodPlanes:e,sizeLods:t,sigmas:n}}function bf(i,e,t){const n=new js(i,e,t);return n.texture.mapping=tl,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function ma(i,e,t,n,s){i.viewport.set(e,t,n,s),i.scissor.set(e,t,n,s)}function $N(i,e,t){const n=new Float32Array(Fs),s=new te(0,1,0);return new gs({name:"SphericalGaussianBlur",defines:{n:Fs,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Jh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:hs,depthTest:!1,depthWrite:!1})}function yf(){return new gs({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Jh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:hs,depthTest:!1,depthWrite:!1})}function xf(){return new gs({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Jh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:hs,depthTest:!1,depthWrite:!1})}function Jh(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function qN(i){let e=new WeakMap,t=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===Ic||l===kc,h=l===zo||l===Bo;if(c||h){let u=e.get(a);const d=u!==void 0?u.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==d)return t===null&&(t=new vf(i)),u=c?t.fromEquirectangular(a,u):t.fromCubemap(a,u),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),u.texture;if(u!==void 0)return u.texture;{const p=a.image;return c&&p&&p.height>0||h&&p&&s(p)?(t===null&&(t=new vf(i)),u=c?t.fromEquirectangular(a):t.fromCubemap(a),u.texture.pmremVersion=a.pmremVersion,e.set(a,u),a.addEventListener("dispose",o),u.texture):null}}}return a}function s(a){let l=0;const c=6;for(let h=0;h<c;h++)a[h]!==void 0&&l++;return l===c}function o(a){const l=a.target;l.removeEventListener("dispose",o);const c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function r(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:n,dispose:r}}function XN(i){const e={};function t(n){if(e[n]!==void 0)return e[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){const s=t(n);return s===null&&_r("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function jN(i,e,t,n){const s={},o=new WeakMap;function r(u){const d=u.target;d.index!==null&&e.remove(d.index);for(const g in d.attributes)e.remove(d.attributes[g]);for(const g in d.morphAttributes){const _=d.morphAttributes[g];for(let m=0,f=_.length;m<f;m++)e.remove(_[m])}d.removeEventListener("dispose",r),delete s[d.id];const p=o.get(d);p&&(e.remove(p),o.delete(d)),n.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function a(u,d){return s[d.id]===!0||(d.addEventListener("dispose",r),s[d.id]=!0,t.memory.geometries++),d}function l(u){const d=u.attributes;for(const g in d)e.update(d[g],i.ARRAY_BUFFER);const p=u.morphAttributes;for(const g in p){const _=p[g];for(let m=0,f=_.length;m<f;m++)e.update(_[m],i.ARRAY_BUFFER)}}function c(u){const d=[],p=u.index,g=u.attributes.position;let _=0;if(p!==null){const M=p.array;_=p.version;for(let S=0,b=M.length;S<b;S+=3){const F=M[S+0],L=M[S+1],A=M[S+2];d.push(F,L,L,A,A,F)}}else if(g!==void 0){const M=g.array;_=g.version;for(let S=0,b=M.length/3-1;S<b;S+=3){const F=S+0,L=S+1,A=S+2;d.push(F,L,L,A,A,F)}}else return;const m=new(Am(d)?Dm:Nm)(d,1);m.version=_;const f=o.get(u);f&&e.remove(f),o.set(u,m)}function h(u){const d=o.get(u);if(d){const p=u.index;p!==null&&d.version<p.version&&c(u)}else c(u);return o.get(u)}return{get:a,update:l,getWireframeAttribute:h}}function YN(i,e,t){let n;function s(d){n=d}let o,r;function a(d){o=d.type,r=d.bytesPerElement}function l(d,p){i.drawElements(n,p,o,d*r),t.update(p,n,1)}function c(d,p,g){g!==0&&(i.drawElementsInstanced(n,p,o,d*r,g),t.update(p,n,g))}function h(d,p,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,o,d,0,g);let m=0;for(let f=0;f<g;f++)m+=p[f];t.update(m,n,1)}function u(d,p,g,_){if(g===0)return;const m=e.get("WEBGL_multi_draw");if(m===null)for(let f=0;f<d.length;f++)c(d[f]/r,p[f],_[f]);else{m.multiDrawElementsInstancedWEBGL(n,p,0,o,d,0,_,0,g);let f=0;for(let M=0;M<g;M++)f+=p[M]*_[M];t.update(f,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h,this.renderMultiDrawInstances=u}function KN(i){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(o,r,a){switch(t.calls++,r){case i.TRIANGLES:t.triangles+=a*(o/3);break;case i.LINES:t.lines+=a*(o/2);break;case i.LINE_STRIP:t.lines+=a*(o-1);break;case i.LINE_LOOP:t.lines+=a*o;break;case i.POINTS:t.points+=a*o;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",r);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function ZN(i,e,t){const n=new WeakMap,s=new Wt;function o(r,a,l){const c=r.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0;let d=n.get(a);if(d===void 0||d.count!==u){let x=function(){U.dispose(),n.delete(a),a.removeEventListener("dispose",x)};var p=x;d!==void 0&&d.texture.dispose();const g=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],M=a.morphAttributes.normal||[],S=a.morphAttributes.color||[];let b=0;g===!0&&(b=1),_===!0&&(b=2),m===!0&&(b=3);let F=a.attributes.position.count*b,L=1;F>e.maxTextureSize&&(L=Math.ceil(F/e.maxTextureSize),F=e.maxTextureSize);const A=new Float32Array(F*L*4*u),U=new Cm(A,F,L,u);U.type=zi,U.needsUpdate=!0;const E=b*4;for(let C=0;C<u;C++){const V=f[C],O=M[C],q=S[C],$=F*L*4*C;for(let X=0;X<V.count;X++){const Y=X*E;g===!0&&(s.fromBufferAttribute(V,X),A[$+Y+0]=s.x,A[$+Y+1]=s.y,A[$+Y+2]=s.z,A[$+Y+3]=0),_===!0&&(s.fromBufferAttribute(O,X),A[$+Y+4]=s.x,A[$+Y+5]=s.y,A[$+Y+6]=s.z,A[$+Y+7]=0),m===!0&&(s.fromBufferAttribute(q,X),A[$+Y+8]=s.x,A[$+Y+9]=s.y,A[$+Y+10]=s.z,A[$+Y+11]=q.itemSize===4?s.w:1)}}d={count:u,texture:U,size:new vt(F,L)},n.set(a,d),a.addEventListener("dispose",x)}if(r.isInstancedMesh===!0&&r.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",r.morphTexture,t);else{let g=0;for(let m=0;m<c.length;m++)g+=c[m];const _=a.morphTargetsRelative?1:1-g;l.getUniforms().setValue(i,"morphTargetBaseInfluence",_),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:o}}function JN(i,e,t,n){let s=new WeakMap;function o(l){const c=n.render.frame,h=l.geometry,u=e.get(l,h);if(s.get(u)!==c&&(e.update(u),s.set(u,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const d=l.skeleton;s.get(d)!==c&&(d.update(),s.set(d,c))}return u}function r(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:o,dispose:r}}class zm extends Tn{constructor(e,t,n,s,o,r,a,l,c,h=No){if(h!==No&&h!==Vo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&h===No&&(n=Xs),n===void 0&&h===Vo&&(n=Ho),super(null,s,o,r,a,l,h,n,c),this.isDepthTexture=!0,this.image={width:e,height:t},this.magFilter=a!==void 0?a:hi,this.minFilter=l!==void 0?l:hi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}const Bm=new Tn,Mf=new zm(1,1),Hm=new Cm,Vm=new O2,Gm=new Um,Sf=[],wf=[],Ef=new Float32Array(16),Tf=new Float32Array(9),Af=new Float32Array(4);function Zo(i,e,t){const n=i[0];if(n<=0||n>0)return i;const s=e*t;let o=Sf[s];if(o===void 0&&(o=new Float32Array(s),Sf[s]=o),e!==0){n.toArray(o,0);for(let r=1,a=0;r!==e;++r)a+=t,i[r].toArray(o,a)}return o}function en(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function tn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function il(i,e){let t=wf[e];t===void 0&&(t=new Int32Array(e),wf[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function QN(i,e){const t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function eD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2fv(this.addr,e),tn(t,e)}}function tD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(en(t,e))return;i.uniform3fv(this.addr,e),tn(t,e)}}function nD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4fv(this.addr,e),tn(t,e)}}function iD(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Af.set(n),i.uniformMatrix2fv(this.addr,!1,Af),tn(t,n)}}function sD(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Tf.set(n),i.uniformMatrix3fv(this.addr,!1,Tf),tn(t,n)}}function oD(i,e){const t=this.cache,n=e.elements;if(n===void 0){if(en(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),tn(t,e)}else{if(en(t,n))return;Ef.set(n),i.uniformMatrix4fv(this.addr,!1,Ef),tn(t,n)}}function rD(i,e){const t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function aD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2iv(this.addr,e),tn(t,e)}}function lD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3iv(this.addr,e),tn(t,e)}}function cD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4iv(this.addr,e),tn(t,e)}}function hD(i,e){const t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function uD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(en(t,e))return;i.uniform2uiv(this.addr,e),tn(t,e)}}function dD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(en(t,e))return;i.uniform3uiv(this.addr,e),tn(t,e)}}function fD(i,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(en(t,e))return;i.uniform4uiv(this.addr,e),tn(t,e)}}function pD(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let o;this.type===i.SAMPLER_2D_SHADOW?(Mf.compareFunction=Tm,o=Mf):o=Bm,t.setTexture2D(e||o,s)}function mD(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Vm,s)}function gD(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTextureCube(e||Gm,s)}function _D(i,e,t){const n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Hm,s)}function vD(i){switch(i){case 5126:return QN;case 35664:return eD;case 35665:return tD;case 35666:return nD;case 35674:return iD;case 35675:return sD;case 35676:return oD;case 5124:case 35670:return rD;case 35667:case 35671:return aD;case 35668:case 35672:return lD;case 35669:case 35673:return cD;case 5125:return hD;case 36294:return uD;case 36295:return dD;case 36296:return fD;case 35678:case 36198:case 36298:case 36306:case 35682:return pD;case 35679:case 36299:case 36307:return mD;case 35680:case 36300:case 36308:case 36293:return gD;case 36289:case 36303:case 36311:case 36292:return _D}}function bD(i,e){i.uniform1fv(this.addr,e)}function yD(i,e){const t=Zo(e,this.size,2);i.uniform2fv(this.addr,t)}function xD(i,e){const t=Zo(e,this.size,3);i.uniform3fv(this.addr,t)}function MD(i,e){const t=Zo(e,this.size,4);i.uniform4fv(this.addr,t)}function SD(i,e){const t=Zo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function wD(i,e){const t=Zo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function ED(i,e){const t=Zo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function TD(i,e){i.uniform1iv(this.addr,e)}function AD(i,e){i.uniform2iv(this.addr,e)}function RD(i,e){i.uniform3iv(this.addr,e)}function CD(i,e){i.uniform4iv(this.addr,e)}function PD(i,e){i.uniform1uiv(this.addr,e)}function LD(i,e){i.uniform2uiv(this.addr,e)}function ND(i,e){i.uniform3uiv(this.addr,e)}function DD(i,e){i.uniform4uiv(this.addr,e)}function ID(i,e,t){const n=this.cache,s=e.length,o=il(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTexture2D(e[r]||Bm,o[r])}function kD(i,e,t){const n=this.cache,s=e.length,o=il(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTexture3D(e[r]||Vm,o[r])}function UD(i,e,t){const n=this.cache,s=e.length,o=il(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTextureCube(e[r]||Gm,o[r])}function FD(i,e,t){const n=this.cache,s=e.length,o=il(t,s);en(n,o)||(i.uniform1iv(this.addr,o),tn(n,o));for(let r=0;r!==s;++r)t.setTexture2DArray(e[r]||Hm,o[r])}function OD(i){switch(i){case 5126:return bD;case 35664:return yD;case 35665:return xD;case 35666:return MD;case 35674:return SD;case 35675:return wD;case 35676:return ED;case 5124:case 35670:return TD;case 35667:case 35671:return AD;case 35668:case 35672:return RD;case 35669:case 35673:return CD;case 5125:return PD;case 36294:return LD;case 36295:return ND;case 36296:return DD;case 35678:case 36198:case 36298:case 36306:case 35682:return ID;case 35679:case 36299:case 36307:return kD;case 35680:case 36300:case 36308:case 36293:return UD;case 36289:case 36303:case 36311:case 36292:return FD}}class zD{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=vD(t.type)}}class BD{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=OD(t.type)}}class HD{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){const s=this.seq;for(let o=0,r=s.length;o!==r;++o){const a=s[o];a.setValue(e,t[a.id],n)}}}const ic=/(\w+)(\])?(\[|\.)?/g;function Rf(i,e){i.seq.push(e),i.map[e.id]=e}function VD(i,e,t){const n=i.name,s=n.length;for(ic.lastIndex=0;;){const o=ic.exec(n),r=ic.lastIndex;let a=o[1];const l=o[2]==="]",c=o[3];if(l&&(a=a|0),c===void 0||c==="["&&r+2===s){Rf(t,c===void 0?new zD(a,i,e):new BD(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new HD(a),Rf(t,u)),t=u}}}class Ra{constructor(e,t){this.seq=[],this.map={};const n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const o=e.getActiveUniform(t,s),r=e.getUniformLocation(t,o.name);VD(o,r,this)}}setValue(e,t,n,s){const o=this.map[t];o!==void 0&&o.setValue(e,n,s)}setOptional(e,t,n){const s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let o=0,r=t.length;o!==r;++o){const a=t[o],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){const n=[];for(let s=0,o=e.length;s!==o;++s){const r=e[s];r.id in t&&n.push(r)}return n}}function Cf(i,e,t){const n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}const GD=37297;let WD=0;function $D(i,e){const t=i.split(`
`),n=[],s=Math.max(e-6,0),o=Math.min(e+6,t.length);for(let r=s;r<o;r++){const a=r+1;n.push(`${a===e?">":" "} ${a}: ${t[r]}`)}return n.join(`
`)}const Pf=new tt;function qD(i){_t._getMatrix(Pf,_t.workingColorSpace,i);const e=`mat3( ${Pf.elements.map(t=>t.toFixed(4))} )`;switch(_t.getTransfer(i)){case nl:return[e,"LinearTransferOETF"];case Rt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Lf(i,e,t){const n=i.getShaderParameter(e,i.COMPILE_STATUS),s=i.getShaderInfoLog(e).trim();if(n&&s==="")return"";const o=/ERROR: 0:(\d+)/.exec(s);if(o){const r=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+$D(i.getShaderSource(e),r)}else return s}function XD(i,e){const t=qD(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function jD(i,e){let t;switch(e){case u2:t="Linear";break;case d2:t="Reinhard";break;case f2:t="Cineon";break;case p2:t="ACESFilmic";break;case g2:t="AgX";break;case _2:t="Neutral";break;case m2:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const ga=new te;function YD(){_t.getLuminanceCoefficients(ga);const i=ga.x.toFixed(4),e=ga.y.toFixed(4),t=ga.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function KD(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(vr).join(`
`)}function ZD(i){const e=[];for(const t in i){const n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function JD(i,e){const t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const o=i.getActiveAttrib(e,s),r=o.name;let a=1;o.type===i.FLOAT_MAT2&&(a=2),o.type===i.FLOAT_MAT3&&(a=3),o.type===i.FLOAT_MAT4&&(a=4),t[r]={type:o.type,location:i.getAttribLocation(e,r),locationSize:a}}return t}function vr(i){return i!==""}function Nf(i,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function Df(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const QD=/^[ \t]*#include +<([\w\d./]+)>/gm;function hh(i){return i.replace(QD,tI)}const eI=new Map;function tI(i,e){let t=it[e];if(t===void 0){const n=eI.get(e);if(n!==void 0)t=it[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,n);else throw new Error("Can not resolve #include <"+e+">")}return hh(t)}const nI=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function If(i){return i.replace(nI,iI)}function iI(i,e,t,n){let s="";for(let o=parseInt(e);o<parseInt(t);o++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+o+" ]").replace(/UNROLLED_LOOP_INDEX/g,o);return s}function kf(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function sI(i){let e="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===um?e="SHADOWMAP_TYPE_PCF":i.shadowMapType===dm?e="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Ui&&(e="SHADOWMAP_TYPE_VSM"),e}function oI(i){let e="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case zo:case Bo:e="ENVMAP_TYPE_CUBE";break;case tl:e="ENVMAP_TYPE_CUBE_UV";break}return e}function rI(i){let e="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Bo:e="ENVMAP_MODE_REFRACTION";break}return e}function aI(i){let e="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case fm:e="ENVMAP_BLENDING_MULTIPLY";break;case c2:e="ENVMAP_BLENDING_MIX";break;case h2:e="ENVMAP_BLENDING_ADD";break}return e}function lI(i){const e=i.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,n=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:n,maxMip:t}}function cI(i,e,t,n){const s=i.getContext(),o=t.defines;let r=t.vertexShader,a=t.fragmentShader;const l=sI(t),c=oI(t),h=rI(t),u=aI(t),d=lI(t),p=KD(t),g=ZD(o),_=s.createProgram();let m,f,M=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(vr).join(`
`),m.length>0&&(m+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(vr).join(`
`),f.length>0&&(f+=`
`)):(m=[kf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(vr).join(`
`),f=[kf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==us?"#define TONE_MAPPING":"",t.toneMapping!==us?it.tonemapping_pars_fragment:"",t.toneMapping!==us?jD("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",it.colorspace_pars_fragment,XD("linearToOutputTexel",t.outputColorSpace),YD(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(vr).join(`
`)),r=hh(r),r=Nf(r,t),r=Df(r,t),a=hh(a),a=Nf(a,t),a=Df(a,t),r=If(r),a=If(a),t.isRawShaderMaterial!==!0&&(M=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,f=["#define varying in",t.glslVersion===Xd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Xd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);const S=M+m+r,b=M+f+a,F=Cf(s,s.VERTEX_SHADER,S),L=Cf(s,s.FRAGMENT_SHADER,b);s.attachShader(_,F),s.attachShader(_,L),t.index0AttributeName!==void 0?s.bindAttribLocation(_,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function A(C){if(i.debug.checkShaderErrors){const V=s.getProgramInfoLog(_).trim(),O=s.getShaderInfoLog(F).trim(),q=s.getShaderInfoLog(L).trim();let $=!0,X=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if($=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,_,F,L);else{const Y=Lf(s,F,"vertex"),ee=Lf(s,L,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+V+`
`+Y+`
`+ee)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(O===""||q==="")&&(X=!1);X&&(C.diagnostics={runnable:$,programLog:V,vertexShader:{log:O,prefix:m},fragmentShader:{log:q,prefix:f}})}s.deleteShader(F),s.deleteShader(L),U=new Ra(s,_),E=JD(s,_)}let U;this.getUniforms=function(){return U===void 0&&A(this),U};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let x=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return x===!1&&(x=s.getProgramParameter(_,GD)),x},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=WD++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=F,this.fragmentShader=L,this}let hI=0;class uI{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,n=e.fragmentShader,s=this._getShaderStage(t),o=this._getShaderStage(n),r=this._getShaderCacheForMaterial(e);return r.has(s)===!1&&(r.add(s),s.usedTimes++),r.has(o)===!1&&(r.add(o),o.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){const t=this.shaderCache;let n=t.get(e);return n===void 0&&(n=new dI(e),t.set(e,n)),n}}class dI{constructor(e){this.id=hI++,this.code=e,this.usedTimes=0}}function fI(i,e,t,n,s,o,r){const a=new Yh,l=new uI,c=new Set,h=[],u=s.logarithmicDepthBuffer,d=s.vertexTextures;let p=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function _(E){return c.add(E),E===0?"uv":`uv${E}`}function m(E,x,C,V,O){const q=V.fog,$=O.geometry,X=E.isMeshStandardMaterial?V.environment:null,Y=(E.isMeshStandardMaterial?t:e).get(E.envMap||X),ee=Y&&Y.mapping===tl?Y.image.height:null,ae=g[E.type];E.precision!==null&&(p=s.getMaxPrecision(E.precision),p!==E.precision&&console.warn("THREE.WebGLProgram.getParameters:",E.precision,"not supported, using",p,"instead."));const ce=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,_e=ce!==void 0?ce.length:0;let be=0;$.morphAttributes.position!==void 0&&(be=1),$.morphAttributes.normal!==void 0&&(be=2),$.morphAttributes.color!==void 0&&(be=3);let me,oe,ue,ve;if(ae){const xt=bi[ae];me=xt.vertexShader,oe=xt.fragmentShader}else me=E.vertexShader,oe=E.fragmentShader,l.update(E),ue=l.getVertexShaderID(E),ve=l.getFragmentShaderID(E);const he=i.getRenderTarget(),Ie=i.state.buffers.depth.getReversed(),Be=O.isInstancedMesh===!0,ke=O.isBatchedMesh===!0,ht=!!E.map,Je=!!E.matcap,ut=!!Y,G=!!E.aoMap,Kt=!!E.lightMap,et=!!E.bumpMap,nt=!!E.normalMap,We=!!E.displacementMap,pt=!!E.emissiveMap,Ne=!!E.metalnessMap,I=!!E.roughnessMap,w=E.anisotropy>0,Q=E.clearcoat>0,ne=E.dispersion>0,j=E.iridescence>0,ie=E.sheen>0,Se=E.transmission>0,ye=w&&!!E.anisotropyMap,Ae=Q&&!!E.clearcoatMap,Ze=Q&&!!E.clearcoatNormalMap,pe=Q&&!!E.clearcoatRoughnessMap,xe=j&&!!E.iridescenceMap,Oe=j&&!!E.iridescenceThicknessMap,He=ie&&!!E.sheenColorMap,Ee=ie&&!!E.sheenRoughnessMap,ot=!!E.specularMap,Ye=!!E.specularColorMap,mt=!!E.specularIntensityMap,H=Se&&!!E.transmissionMap,Me=Se&&!!E.thicknessMap,se=!!E.gradientMap,le=!!E.alphaMap,Re=E.alphaTest>0,Ce=!!E.alphaHash,Qe=!!E.extensions;let Ft=us;E.toneMapped&&(he===null||he.isXRRenderTarget===!0)&&(Ft=i.toneMapping);const nn={shaderID:ae,shaderType:E.type,shaderName:E.name,vertexShader:me,fragmentShader:oe,defines:E.defines,customVertexShaderID:ue,customFragmentShaderID:ve,isRawShaderMaterial:E.isRawShaderMaterial===!0,glslVersion:E.glslVersion,precision:p,batching:ke,batchingColor:ke&&O._colorsTexture!==null,instancing:Be,instancingColor:Be&&O.instanceColor!==null,instancingMorph:Be&&O.morphTexture!==null,supportsVertexTextures:d,outputColorSpace:he===null?i.outputColorSpace:he.isXRRenderTarget===!0?he.texture.colorSpace:Yo,alphaToCoverage:!!E.alphaToCoverage,map:ht,matcap:Je,envMap:ut,envMapMode:ut&&Y.mapping,envMapCubeUVHeight:ee,aoMap:G,lightMap:Kt,bumpMap:et,normalMap:nt,displacementMap:d&&We,emissiveMap:pt,normalMapObjectSpace:nt&&E.normalMapType===x2,normalMapTangentSpace:nt&&E.normalMapType===Em,metalnessMap:Ne,roughnessMap:I,anisotropy:w,anisotropyMap:ye,clearcoat:Q,clearcoatMap:Ae,clearcoatNormalMap:Ze,clearcoatRoughnessMap:pe,dispersion:ne,iridescence:j,iridescenceMap:xe,iridescenceThicknessMap:Oe,sheen:ie,sheenColorMap:He,sheenRoughnessMap:Ee,specularMap:ot,specularColorMap:Ye,specularIntensityMap:mt,transmission:Se,transmissionMap:H,thicknessMap:Me,gradientMap:se,opaque:E.transparent===!1&&E.blending===Lo&&E.alphaToCoverage===!1,alphaMap:le,alphaTest:Re,alphaHash:Ce,combine:E.combine,mapUv:ht&&_(E.map.channel),aoMapUv:G&&_(E.aoMap.channel),lightMapUv:Kt&&_(E.lightMap.channel),bumpMapUv:et&&_(E.bumpMap.channel),normalMapUv:nt&&_(E.normalMap.channel),displacementMapUv:We&&_(E.displacementMap.channel),emissiveMapUv:pt&&_(E.emissiveMap.channel),metalnessMapUv:Ne&&_(E.metalnessMap.channel),roughnessMapUv:I&&_(E.roughnessMap.channel),anisotropyMapUv:ye&&_(E.anisotropyMap.channel),clearcoatMapUv:Ae&&_(E.clearcoatMap.channel),clearcoatNormalMapUv:Ze&&_(E.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:pe&&_(E.clearcoatRoughnessMap.channel),iridescenceMapUv:xe&&_(E.iridescenceMap.channel),iridescenceThicknessMapUv:Oe&&_(E.iridescenceThicknessMap.channel),sheenColorMapUv:He&&_(E.sheenColorMap.channel),sheenRoughnessMapUv:Ee&&_(E.sheenRoughnessMap.channel),specularMapUv:ot&&_(E.specularMap.channel),specularColorMapUv:Ye&&_(E.specularColorMap.channel),specularIntensityMapUv:mt&&_(E.specularIntensityMap.channel),transmissionMapUv:H&&_(E.transmissionMap.channel),thicknessMapUv:Me&&_(E.thicknessMap.channel),alphaMapUv:le&&_(E.alphaMap.channel),vertexTangents:!!$.attributes.tangent&&(nt||w),vertexColors:E.vertexColors,vertexAlphas:E.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,pointsUvs:O.isPoints===!0&&!!$.attributes.uv&&(ht||le),fog:!!q,useFog:E.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:E.flatShading===!0,sizeAttenuation:E.sizeAttenuation===!0,logarithmicDepthBuffer:u,reverseDepthBuffer:Ie,skinning:O.isSkinnedMesh===!0,morphTargets:$.morphAttributes.position!==void 0,morphNormals:$.morphAttributes.normal!==void 0,morphColors:$.morphAttributes.color!==void 0,morphTargetsCount:_e,morphTextureStride:be,numDirLights:x.directional.length,numPointLights:x.point.length,numSpotLights:x.spot.length,numSpotLightMaps:x.spotLightMap.length,numRectAreaLights:x.rectArea.length,numHemiLights:x.hemi.length,numDirLightShadows:x.directionalShadowMap.length,numPointLightShadows:x.pointShadowMap.length,numSpotLightShadows:x.spotShadowMap.length,numSpotLightShadowsWithMaps:x.numSpotLightShadowsWithMaps,numLightProbes:x.numLightProbes,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:E.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:Ft,decodeVideoTexture:ht&&E.map.isVideoTexture===!0&&_t.getTransfer(E.map.colorSpace)===Rt,decodeVideoTextureEmissive:pt&&E.emissiveMap.isVideoTexture===!0&&_t.getTransfer(E.emissiveMap.colorSpace)===Rt,premultipliedAlpha:E.premultipliedAlpha,doubleSided:E.side===Oi,flipSided:E.side===Ln,useDepthPacking:E.depthPacking>=0,depthPacking:E.depthPacking||0,index0AttributeName:E.index0AttributeName,extensionClipCullDistance:Qe&&E.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&E.extensions.multiDraw===!0||ke)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:E.customProgramCacheKey()};return nn.vertexUv1s=c.has(1),nn.vertexUv2s=c.has(2),nn.vertexUv3s=c.has(3),c.clear(),nn}function f(E){const x=[];if(E.shaderID?x.push(E.shaderID):(x.push(E.customVertexShaderID),x.push(E.customFragmentShaderID)),E.defines!==void 0)for(const C in E.defines)x.push(C),x.push(E.defines[C]);return E.isRawShaderMaterial===!1&&(M(x,E),S(x,E),x.push(i.outputColorSpace)),x.push(E.customProgramCacheKey),x.join()}function M(E,x){E.push(x.precision),E.push(x.outputColorSpace),E.push(x.envMapMode),E.push(x.envMapCubeUVHeight),E.push(x.mapUv),E.push(x.alphaMapUv),E.push(x.lightMapUv),E.push(x.aoMapUv),E.push(x.bumpMapUv),E.push(x.normalMapUv),E.push(x.displacementMapUv),E.push(x.emissiveMapUv),E.push(x.metalnessMapUv),E.push(x.roughnessMapUv),E.push(x.anisotropyMapUv),E.push(x.clearcoatMapUv),E.push(x.clearcoatNormalMapUv),E.push(x.clearcoatRoughnessMapUv),E.push(x.iridescenceMapUv),E.push(x.iridescenceThicknessMapUv),E.push(x.sheenColorMapUv),E.push(x.sheenRoughnessMapUv),E.push(x.specularMapUv),E.push(x.specularColorMapUv),E.push(x.specularIntensityMapUv),E.push(x.transmissionMapUv),E.push(x.thicknessMapUv),E.push(x.combine),E.push(x.fogExp2),E.push(x.sizeAttenuation),E.push(x.morphTargetsCount),E.push(x.morphAttributeCount),E.push(x.numDirLights),E.push(x.numPointLights),E.push(x.numSpotLights),E.push(x.numSpotLightMaps),E.push(x.numHemiLights),E.push(x.numRectAreaLights),E.push(x.numDirLightShadows),E.push(x.numPointLightShadows),E.push(x.numSpotLightShadows),E.push(x.numSpotLightShadowsWithMaps),E.push(x.numLightProbes),E.push(x.shadowMapType),E.push(x.toneMapping),E.push(x.numClippingPlanes),E.push(x.numClipIntersection),E.push(x.depthPacking)}function S(E,x){a.disableAll(),x.supportsVertexTextures&&a.enable(0),x.instancing&&a.enable(1),x.instancingColor&&a.enable(2),x.instancingMorph&&a.enable(3),x.matcap&&a.enable(4),x.envMap&&a.enable(5),x.normalMapObjectSpace&&a.enable(6),x.normalMapTangentSpace&&a.enable(7),x.clearcoat&&a.enable(8),x.iridescence&&a.enable(9),x.alphaTest&&a.enable(10),x.vertexColors&&a.enable(11),x.vertexAlphas&&a.enable(12),x.vertexUv1s&&a.enable(13),x.vertexUv2s&&a.enable(14),x.vertexUv3s&&a.enable(15),x.vertexTangents&&a.enable(16),x.anisotropy&&a.enable(17),x.alphaHash&&a.enable(18),x.batching&&a.enable(19),x.dispersion&&a.enable(20),x.batchingColor&&a.enable(21),E.push(a.mask),a.disableAll(),x.fog&&a.enable(0),x.useFog&&a.enable(1),x.flatShading&&a.enable(2),x.logarithmicDepthBuffer&&a.enable(3),x.reverseDepthBuffer&&a.enable(4),x.skinning&&a.enable(5),x.morphTargets&&a.enable(6),x.morphNormals&&a.enable(7),x.morphColors&&a.enable(8),x.premultipliedAlpha&&a.enable(9),x.shadowMapEnabled&&a.enable(10),x.doubleSided&&a.enable(11),x.flipSided&&a.enable(12),x.useDepthPacking&&a.enable(13),x.dithering&&a.enable(14),x.transmission&&a.enable(15),x.sheen&&a.enable(16),x.opaque&&a.enable(17),x.pointsUvs&&a.enable(18),x.decodeVideoTexture&&a.enable(19),x.decodeVideoTextureEmissive&&a.enable(20),x.alphaToCoverage&&a.enable(21),E.push(a.mask)}function b(E){const x=g[E.type];let C;if(x){const V=bi[x];C=K2.clone(V.uniforms)}else C=E.uniforms;return C}function F(E,x){let C;for(let V=0,O=h.length;V<O;V++){const q=h[V];if(q.cacheKey===x){C=q,++C.usedTimes;break}}return C===void 0&&(C=new cI(i,x,E,o),h.push(C)),C}function L(E){if(--E.usedTimes===0){const x=h.indexOf(E);h[x]=h[h.length-1],h.pop(),E.destroy()}}function A(E){l.remove(E)}function U(){l.dispose()}return{getParameters:m,getProgramCacheKey:f,getUniforms:b,acquireProgram:F,releaseProgram:L,releaseShaderCache:A,programs:h,dispose:U}}function pI(){let i=new WeakMap;function e(r){return i.has(r)}function t(r){let a=i.get(r);return a===void 0&&(a={},i.set(r,a)),a}function n(r){i.delete(r)}function s(r,a,l){i.get(r)[a]=l}function o(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:o}}function mI(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.z!==e.z?i.z-e.z:i.id-e.id}function Uf(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Ff(){const i=[];let e=0;const t=[],n=[],s=[];function o(){e=0,t.length=0,n.length=0,s.length=0}function r(u,d,p,g,_,m){let f=i[e];return f===void 0?(f={id:u.id,object:u,geometry:d,material:p,groupOrder:g,renderOrder:u.renderOrder,z:_,group:m},i[e]=f):(f.id=u.id,f.object=u,f.geometry=d,f.material=p,f.groupOrder=g,f.renderOrder=u.renderOrder,f.z=_,f.group=m),e++,f}function a(u,d,p,g,_,m){const f=r(u,d,p,g,_,m);p.transmission>0?n.push(f):p.transparent===!0?s.push(f):t.push(f)}function l(u,d,p,g,_,m){const f=r(u,d,p,g,_,m);p.transmission>0?n.unshift(f):p.transparent===!0?s.unshift(f):t.unshift(f)}function c(u,d){t.length>1&&t.sort(u||mI),n.length>1&&n.sort(d||Uf),s.length>1&&s.sort(d||Uf)}function h(){for(let u=e,d=i.length;u<d;u++){const p=i[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:o,push:a,unshift:l,finish:h,sort:c}}function gI(){let i=new WeakMap;function e(n,s){const o=i.get(n);let r;return o===void 0?(r=new Ff,i.set(n,[r])):s>=o.length?(r=new Ff,o.push(r)):r=o[s],r}function t(){i=new WeakMap}return{get:e,dispose:t}}function _I(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new te,color:new ft};break;case"SpotLight":t={position:new te,direction:new te,color:new ft,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new te,color:new ft,distance:0,decay:0};break;case"HemisphereLight":t={direction:new te,skyColor:new ft,groundColor:new ft};break;case"RectAreaLight":t={color:new ft,position:new te,halfWidth:new te,halfHeight:new te};break}return i[e.id]=t,t}}}function vI(){const i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new vt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}let bI=0;function yI(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function xI(i){const e=new _I,t=vI(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new te);const s=new te,o=new Ht,r=new Ht;function a(c){let h=0,u=0,d=0;for(let E=0;E<9;E++)n.probe[E].set(0,0,0);let p=0,g=0,_=0,m=0,f=0,M=0,S=0,b=0,F=0,L=0,A=0;c.sort(yI);for(let E=0,x=c.length;E<x;E++){const C=c[E],V=C.color,O=C.intensity,q=C.distance,$=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)h+=V.r*O,u+=V.g*O,d+=V.b*O;else if(C.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(C.sh.coefficients[X],O);A++}else if(C.isDirectionalLight){const X=e.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Y=C.shadow,ee=t.get(C);ee.shadowIntensity=Y.intensity,ee.shadowBias=Y.bias,ee.shadowNormalBias=Y.normalBias,ee.shadowRadius=Y.radius,ee.shadowMapSize=Y.mapSize,n.directionalShadow[p]=ee,n.directionalShadowMap[p]=$,n.directionalShadowMatrix[p]=C.shadow.matrix,M++}n.directional[p]=X,p++}else if(C.isSpotLight){const X=e.get(C);X.position.setFromMatrixPosition(C.matrixWorld),X.color.copy(V).multiplyScalar(O),X.distance=q,X.coneCos=Math.cos(C.angle),X.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),X.decay=C.decay,n.spot[_]=X;const Y=C.shadow;if(C.map&&(n.spotLightMap[F]=C.map,F++,Y.updateMatrices(C),C.castShadow&&L++),n.spotLightMatrix[_]=Y.matrix,C.castShadow){const ee=t.get(C);ee.shadowIntensity=Y.intensity,ee.shadowBias=Y.bias,ee.shadowNormalBias=Y.normalBias,ee.shadowRadius=Y.radius,ee.shadowMapSize=Y.mapSize,n.spotShadow[_]=ee,n.spotShadowMap[_]=$,b++}_++}else if(C.isRectAreaLight){const X=e.get(C);X.color.copy(V).multiplyScalar(O),X.halfWidth.set(C.width*.5,0,0),X.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=X,m++}else if(C.isPointLight){const X=e.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),X.distance=C.distance,X.decay=C.decay,C.castShadow){const Y=C.shadow,ee=t.get(C);ee.shadowIntensity=Y.intensity,ee.shadowBias=Y.bias,ee.shadowNormalBias=Y.normalBias,ee.shadowRadius=Y.radius,ee.shadowMapSize=Y.mapSize,ee.shadowCameraNear=Y.camera.near,ee.shadowCameraFar=Y.camera.far,n.pointShadow[g]=ee,n.pointShadowMap[g]=$,n.pointShadowMatrix[g]=C.shadow.matrix,S++}n.point[g]=X,g++}else if(C.isHemisphereLight){const X=e.get(C);X.skyColor.copy(C.color).multiplyScalar(O),X.groundColor.copy(C.groundColor).multiplyScalar(O),n.hemi[f]=X,f++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Te.LTC_FLOAT_1,n.rectAreaLTC2=Te.LTC_FLOAT_2):(n.rectAreaLTC1=Te.LTC_HALF_1,n.rectAreaLTC2=Te.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;const U=n.hash;(U.directionalLength!==p||U.pointLength!==g||U.spotLength!==_||U.rectAreaLength!==m||U.hemiLength!==f||U.numDirectionalShadows!==M||U.numPointShadows!==S||U.numSpotShadows!==b||U.numSpotMaps!==F||U.numLightProbes!==A)&&(n.directional.length=p,n.spot.length=_,n.rectArea.length=m,n.point.length=g,n.hemi.length=f,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.pointShadow.length=S,n.pointShadowMap.length=S,n.spotShadow.length=b,n.spotShadowMap.length=b,n.directionalShadowMatrix.length=M,n.pointShadowMatrix.length=S,n.spotLightMatrix.length=b+F-L,n.spotLightMap.length=F,n.numSpotLightShadowsWithMaps=L,n.numLightProbes=A,U.directionalLength=p,U.pointLength=g,U.spotLength=_,U.rectAreaLength=m,U.hemiLength=f,U.numDirectionalShadows=M,U.numPointShadows=S,U.numSpotShadows=b,U.numSpotMaps=F,U.numLightProbes=A,n.version=bI++)}function l(c,h){let u=0,d=0,p=0,g=0,_=0;const m=h.matrixWorldInverse;for(let f=0,M=c.length;f<M;f++){const S=c[f];if(S.isDirectionalLight){const b=n.directional[u];b.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(m),u++}else if(S.isSpotLight){const b=n.spot[p];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(m),b.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(m),p++}else if(S.isRectAreaLight){const b=n.rectArea[g];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(m),r.identity(),o.copy(S.matrixWorld),o.premultiply(m),r.extractRotation(o),b.halfWidth.set(S.width*.5,0,0),b.halfHeight.set(0,S.height*.5,0),b.halfWidth.applyMatrix4(r),b.halfHeight.applyMatrix4(r),g++}else if(S.isPointLight){const b=n.point[d];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){const b=n.hemi[_];b.direction.setFromMatrixPosition(S.matrixWorld),b.direction.transformDirection(m),_++}}}return{setup:a,setupView:l,state:n}}function Of(i){const e=new xI(i),t=[],n=[];function s(h){c.camera=h,t.length=0,n.length=0}function o(h){t.push(h)}function r(h){n.push(h)}function a(){e.setup(t)}function l(h){e.setupView(t,h)}const c={lightsArray:t,shadowsArray:n,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:o,pushShadow:r}}function MI(i){let e=new WeakMap;function t(s,o=0){const r=e.get(s);let a;return r===void 0?(a=new Of(i),e.set(s,[a])):o>=r.length?(a=new Of(i),r.push(a)):a=r[o],a}function n(){e=new WeakMap}return{get:t,dispose:n}}class SI extends Dr{static get type(){return"MeshDepthMaterial"}constructor(e){super(),this.isMeshDepthMaterial=!0,this.depthPacking=b2,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class wI extends Dr{static get type(){return"MeshDistanceMaterial"}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const EI=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,TI=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function AI(i,e,t){let n=new Zh;const s=new vt,o=new vt,r=new Wt,a=new SI({depthPacking:y2}),l=new wI,c={},h=t.maxTextureSize,u={[ms]:Ln,[Ln]:ms,[Oi]:Oi},d=new gs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new vt},radius:{value:4}},vertexShader:EI,fragmentShader:TI}),p=d.clone();p.defines.HORIZONTAL_PASS=1;const g=new _s;g.setAttribute("position",new Si(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const _=new dn(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=um;let f=this.type;this.render=function(L,A,U){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||L.length===0)return;const E=i.getRenderTarget(),x=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),V=i.state;V.setBlending(hs),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const O=f!==Ui&&this.type===Ui,q=f===Ui&&this.type!==Ui;for(let $=0,X=L.length;$<X;$++){const Y=L[$],ee=Y.shadow;if(ee===void 0){console.warn("THREE.WebGLShadowMap:",Y,"has no shadow.");continue}if(ee.autoUpdate===!1&&ee.needsUpdate===!1)continue;s.copy(ee.mapSize);const ae=ee.getFrameExtents();if(s.multiply(ae),o.copy(ee.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(o.x=Math.floor(h/ae.x),s.x=o.x*ae.x,ee.mapSize.x=o.x),s.y>h&&(o.y=Math.floor(h/ae.y),s.y=o.y*ae.y,ee.mapSize.y=o.y)),ee.map===null||O===!0||q===!0){const _e=this.type!==Ui?{minFilter:hi,magFilter:hi}:{};ee.map!==null&&ee.map.dispose(),ee.map=new js(s.x,s.y,_e),ee.map.texture.name=Y.name+".shadowMap",ee.camera.updateProjectionMatrix()}i.setRenderTarget(ee.map),i.clear();const ce=ee.getViewportCount();for(let _e=0;_e<ce;_e++){const be=ee.getViewport(_e);r.set(o.x*be.x,o.y*be.y,o.x*be.z,o.y*be.w),V.viewport(r),ee.updateMatrices(Y,_e),n=ee.getFrustum(),b(A,U,ee.camera,Y,this.type)}ee.isPointLightShadow!==!0&&this.type===Ui&&M(ee,U),ee.needsUpdate=!1}f=this.type,m.needsUpdate=!1,i.setRenderTarget(E,x,C)};function M(L,A){const U=e.update(_);d.defines.VSM_SAMPLES!==L.blurSamples&&(d.defines.VSM_SAMPLES=L.blurSamples,p.defines.VSM_SAMPLES=L.blurSamples,d.needsUpdate=!0,p.needsUpdate=!0),L.mapPass===null&&(L.mapPass=new js(s.x,s.y)),d.uniforms.shadow_pass.value=L.map.texture,d.uniforms.resolution.value=L.mapSize,d.uniforms.radius.value=L.radius,i.setRenderTarget(L.mapPass),i.clear(),i.renderBufferDirect(A,null,U,d,_,null),p.uniforms.shadow_pass.value=L.mapPass.texture,p.uniforms.resolution.value=L.mapSize,p.uniforms.radius.value=L.radius,i.setRenderTarget(L.map),i.clear(),i.renderBufferDirect(A,null,U,p,_,null)}function S(L,A,U,E){let x=null;const C=U.isPointLight===!0?L.customDistanceMaterial:L.customDepthMaterial;if(C!==void 0)x=C;else if(x=U.isPointLight===!0?l:a,i.localClippingEnabled&&A.clipShadows===!0&&Array.isArray(A.clippingPlanes)&&A.clippingPlanes.length!==0||A.displacementMap&&A.displacementScale!==0||A.alphaMap&&A.alphaTest>0||A.map&&A.alphaTest>0){const V=x.uuid,O=A.uuid;let q=c[V];q===void 0&&(q={},c[V]=q);let $=q[O];$===void 0&&($=x.clone(),q[O]=$,A.addEventListener("dispose",F)),x=$}if(x.visible=A.visible,x.wireframe=A.wireframe,E===Ui?x.side=A.shadowSide!==null?A.shadowSide:A.side:x.side=A.shadowSide!==null?A.shadowSide:u[A.side],x.alphaMap=A.alphaMap,x.alphaTest=A.alphaTest,x.map=A.map,x.clipShadows=A.clipShadows,x.clippingPlanes=A.clippingPlanes,x.clipIntersection=A.clipIntersection,x.displacementMap=A.displacementMap,x.displacementScale=A.displacementScale,x.displacementBias=A.displacementBias,x.wireframeLinewidth=A.wireframeLinewidth,x.linewidth=A.linewidth,U.isPointLight===!0&&x.isMeshDistanceMaterial===!0){const V=i.properties.get(x);V.light=U}return x}function b(L,A,U,E,x){if(L.visible===!1)return;if(L.layers.test(A.layers)&&(L.isMesh||L.isLine||L.isPoints)&&(L.castShadow||L.receiveShadow&&x===Ui)&&(!L.frustumCulled||n.intersectsObject(L))){L.modelViewMatrix.multiplyMatrices(U.matrixWorldInverse,L.matrixWorld);const O=e.update(L),q=L.material;if(Array.isArray(q)){const $=O.groups;for(let X=0,Y=$.length;X<Y;X++){const ee=$[X],ae=q[ee.materialIndex];if(ae&&ae.visible){const ce=S(L,ae,E,x);L.onBeforeShadow(i,L,A,U,O,ce,ee),i.renderBufferDirect(U,null,O,ce,L,ee),L.onAfterShadow(i,L,A,U,O,ce,ee)}}}else if(q.visible){const $=S(L,q,E,x);L.onBeforeShadow(i,L,A,U,O,$,null),i.renderBufferDirect(U,null,O,$,L,null),L.onAfterShadow(i,L,A,U,O,$,null)}}const V=L.children;for(let O=0,q=V.length;O<q;O++)b(V[O],A,U,E,x)}function F(L){L.target.removeEventListener("dispose",F);for(const U in c){const E=c[U],x=L.target.uuid;x in E&&(E[x].dispose(),delete E[x])}}}const RI={[Ac]:Rc,[Cc]:Nc,[Pc]:Dc,[Oo]:Lc,[Rc]:Ac,[Nc]:Cc,[Dc]:Pc,[Lc]:Oo};function CI(i,e){function t(){let H=!1;const Me=new Wt;let se=null;const le=new Wt(0,0,0,0);return{setMask:function(Re){se!==Re&&!H&&(i.colorMask(Re,Re,Re,Re),se=Re)},setLocked:function(Re){H=Re},setClear:function(Re,Ce,Qe,Ft,nn){nn===!0&&(Re*=Ft,Ce*=Ft,Qe*=Ft),Me.set(Re,Ce,Qe,Ft),le.equals(Me)===!1&&(i.clearColor(Re,Ce,Qe,Ft),le.copy(Me))},reset:function(){H=!1,se=null,le.set(-1,0,0,0)}}}function n(){let H=!1,Me=!1,se=null,le=null,Re=null;return{setReversed:function(Ce){if(Me!==Ce){const Qe=e.get("EXT_clip_control");Me?Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.ZERO_TO_ONE_EXT):Qe.clipControlEXT(Qe.LOWER_LEFT_EXT,Qe.NEGATIVE_ONE_TO_ONE_EXT);const Ft=Re;Re=null,this.setClear(Ft)}Me=Ce},getReversed:function(){return Me},setTest:function(Ce){Ce?he(i.DEPTH_TEST):Ie(i.DEPTH_TEST)},setMask:function(Ce){se!==Ce&&!H&&(i.depthMask(Ce),se=Ce)},setFunc:function(Ce){if(Me&&(Ce=RI[Ce]),le!==Ce){switch(Ce){case Ac:i.depthFunc(i.NEVER);break;case Rc:i.depthFunc(i.ALWAYS);break;case Cc:i.depthFunc(i.LESS);break;case Oo:i.depthFunc(i.LEQUAL);break;case Pc:i.depthFunc(i.EQUAL);break;case Lc:i.depthFunc(i.GEQUAL);break;case Nc:i.depthFunc(i.GREATER);break;case Dc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}le=Ce}},setLocked:function(Ce){H=Ce},setClear:function(Ce){Re!==Ce&&(Me&&(Ce=1-Ce),i.clearDepth(Ce),Re=Ce)},reset:function(){H=!1,se=null,le=null,Re=null,Me=!1}}}function s(){let H=!1,Me=null,se=null,le=null,Re=null,Ce=null,Qe=null,Ft=null,nn=null;return{setTest:function(xt){H||(xt?he(i.STENCIL_TEST):Ie(i.STENCIL_TEST))},setMask:function(xt){Me!==xt&&!H&&(i.stencilMask(xt),Me=xt)},setFunc:function(xt,Zt,Nt){(se!==xt||le!==Zt||Re!==Nt)&&(i.stencilFunc(xt,Zt,Nt),se=xt,le=Zt,Re=Nt)},setOp:function(xt,Zt,Nt){(Ce!==xt||Qe!==Zt||Ft!==Nt)&&(i.stencilOp(xt,Zt,Nt),Ce=xt,Qe=Zt,Ft=Nt)},setLocked:function(xt){H=xt},setClear:function(xt){nn!==xt&&(i.clearStencil(xt),nn=xt)},reset:function(){H=!1,Me=null,se=null,le=null,Re=null,Ce=null,Qe=null,Ft=null,nn=null}}}const o=new t,r=new n,a=new s,l=new WeakMap,c=new WeakMap;let h={},u={},d=new WeakMap,p=[],g=null,_=!1,m=null,f=null,M=null,S=null,b=null,F=null,L=null,A=new ft(0,0,0),U=0,E=!1,x=null,C=null,V=null,O=null,q=null;const $=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let X=!1,Y=0;const ee=i.getParameter(i.VERSION);ee.indexOf("WebGL")!==-1?(Y=parseFloat(/^WebGL (\d)/.exec(ee)[1]),X=Y>=1):ee.indexOf("OpenGL ES")!==-1&&(Y=parseFloat(/^OpenGL ES (\d)/.exec(ee)[1]),X=Y>=2);let ae=null,ce={};const _e=i.getParameter(i.SCISSOR_BOX),be=i.getParameter(i.VIEWPORT),me=new Wt().fromArray(_e),oe=new Wt().fromArray(be);function ue(H,Me,se,le){const Re=new Uint8Array(4),Ce=i.createTexture();i.bindTexture(H,Ce),i.texParameteri(H,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(H,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Qe=0;Qe<se;Qe++)H===i.TEXTURE_3D||H===i.TEXTURE_2D_ARRAY?i.texImage3D(Me,0,i.RGBA,1,1,le,0,i.RGBA,i.UNSIGNED_BYTE,Re):i.texImage2D(Me+Qe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Re);return Ce}const ve={};ve[i.TEXTURE_2D]=ue(i.TEXTURE_2D,i.TEXTURE_2D,1),ve[i.TEXTURE_CUBE_MAP]=ue(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[i.TEXTURE_2D_ARRAY]=ue(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ve[i.TEXTURE_3D]=ue(i.TEXTURE_3D,i.TEXTURE_3D,1,1),o.setClear(0,0,0,1),r.setClear(1),a.setClear(0),he(i.DEPTH_TEST),r.setFunc(Oo),et(!1),nt(Hd),he(i.CULL_FACE),G(hs);function he(H){h[H]!==!0&&(i.enable(H),h[H]=!0)}function Ie(H){h[H]!==!1&&(i.disable(H),h[H]=!1)}function Be(H,Me){return u[H]!==Me?(i.bindFramebuffer(H,Me),u[H]=Me,H===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=Me),H===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=Me),!0):!1}function ke(H,Me){let se=p,le=!1;if(H){se=d.get(Me),se===void 0&&(se=[],d.set(Me,se));const Re=H.textures;if(se.length!==Re.length||se[0]!==i.COLOR_ATTACHMENT0){for(let Ce=0,Qe=Re.length;Ce<Qe;Ce++)se[Ce]=i.COLOR_ATTACHMENT0+Ce;se.length=Re.length,le=!0}}else se[0]!==i.BACK&&(se[0]=i.BACK,le=!0);le&&i.drawBuffers(se)}function ht(H){return g!==H?(i.useProgram(H),g=H,!0):!1}const Je={[Us]:i.FUNC_ADD,[qC]:i.FUNC_SUBTRACT,[XC]:i.FUNC_REVERSE_SUBTRACT};Je[jC]=i.MIN,Je[YC]=i.MAX;const ut={[KC]:i.ZERO,[ZC]:i.ONE,[JC]:i.SRC_COLOR,[Ec]:i.SRC_ALPHA,[s2]:i.SRC_ALPHA_SATURATE,[n2]:i.DST_COLOR,[e2]:i.DST_ALPHA,[QC]:i.ONE_MINUS_SRC_COLOR,[Tc]:i.ONE_MINUS_SRC_ALPHA,[i2]:i.ONE_MINUS_DST_COLOR,[t2]:i.ONE_MINUS_DST_ALPHA,[o2]:i.CONSTANT_COLOR,[r2]:i.ONE_MINUS_CONSTANT_COLOR,[a2]:i.CONSTANT_ALPHA,[l2]:i.ONE_MINUS_CONSTANT_ALPHA};function G(H,Me,se,le,Re,Ce,Qe,Ft,nn,xt){if(H===hs){_===!0&&(Ie(i.BLEND),_=!1);return}if(_===!1&&(he(i.BLEND),_=!0),H!==$C){if(H!==m||xt!==E){if((f!==Us||b!==Us)&&(i.blendEquation(i.FUNC_ADD),f=Us,b=Us),xt)switch(H){case Lo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vd:i.blendFunc(i.ONE,i.ONE);break;case Gd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Wd:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}else switch(H){case Lo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vd:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case Gd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Wd:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",H);break}M=null,S=null,F=null,L=null,A.set(0,0,0),U=0,m=H,E=xt}return}Re=Re||Me,Ce=Ce||se,Qe=Qe||le,(Me!==f||Re!==b)&&(i.blendEquationSeparate(Je[Me],Je[Re]),f=Me,b=Re),(se!==M||le!==S||Ce!==F||Qe!==L)&&(i.blendFuncSeparate(ut[se],ut[le],ut[Ce],ut[Qe]),M=se,S=le,F=Ce,L=Qe),(Ft.equals(A)===!1||nn!==U)&&(i.blendColor(Ft.r,Ft.g,Ft.b,nn),A.copy(Ft),U=nn),m=H,E=!1}function Kt(H,Me){H.side===Oi?Ie(i.CULL_FACE):he(i.CULL_FACE);let se=H.side===Ln;Me&&(se=!se),et(se),H.blending===Lo&&H.transparent===!1?G(hs):G(H.blending,H.blendEquation,H.blendSrc,H.blendDst,H.blendEquationAlpha,H.blendSrcAlpha,H.blendDstAlpha,H.blendColor,H.blendAlpha,H.premultipliedAlpha),r.setFunc(H.depthFunc),r.setTest(H.depthTest),r.setMask(H.depthWrite),o.setMask(H.colorWrite);const le=H.stencilWrite;a.setTest(le),le&&(a.setMask(H.stencilWriteMask),a.setFunc(H.stencilFunc,H.stencilRef,H.stencilFuncMask),a.setOp(H.stencilFail,H.stencilZFail,H.stencilZPass)),pt(H.polygonOffset,H.polygonOffsetFactor,H.polygonOffsetUnits),H.alphaToCoverage===!0?he(i.SAMPLE_ALPHA_TO_COVERAGE):Ie(i.SAMPLE_ALPHA_TO_COVERAGE)}function et(H){x!==H&&(H?i.frontFace(i.CW):i.frontFace(i.CCW),x=H)}function nt(H){H!==GC?(he(i.CULL_FACE),H!==C&&(H===Hd?i.cullFace(i.BACK):H===WC?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ie(i.CULL_FACE),C=H}function We(H){H!==V&&(X&&i.lineWidth(H),V=H)}function pt(H,Me,se){H?(he(i.POLYGON_OFFSET_FILL),(O!==Me||q!==se)&&(i.polygonOffset(Me,se),O=Me,q=se)):Ie(i.POLYGON_OFFSET_FILL)}function Ne(H){H?he(i.SCISSOR_TEST):Ie(i.SCISSOR_TEST)}function I(H){H===void 0&&(H=i.TEXTURE0+$-1),ae!==H&&(i.activeTexture(H),ae=H)}function w(H,Me,se){se===void 0&&(ae===null?se=i.TEXTURE0+$-1:se=ae);let le=ce[se];le===void 0&&(le={type:void 0,texture:void 0},ce[se]=le),(le.type!==H||le.texture!==Me)&&(ae!==se&&(i.activeTexture(se),ae=se),i.bindTexture(H,Me||ve[H]),le.type=H,le.texture=Me)}function Q(){const H=ce[ae];H!==void 0&&H.type!==void 0&&(i.bindTexture(H.type,null),H.type=void 0,H.texture=void 0)}function ne(){try{i.compressedTexImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function j(){try{i.compressedTexImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ie(){try{i.texSubImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Se(){try{i.texSubImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function ye(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Ae(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Ze(){try{i.texStorage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function pe(){try{i.texStorage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function xe(){try{i.texImage2D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function Oe(){try{i.texImage3D.apply(i,arguments)}catch(H){console.error("THREE.WebGLState:",H)}}function He(H){me.equals(H)===!1&&(i.scissor(H.x,H.y,H.z,H.w),me.copy(H))}function Ee(H){oe.equals(H)===!1&&(i.viewport(H.x,H.y,H.z,H.w),oe.copy(H))}function ot(H,Me){let se=c.get(Me);se===void 0&&(se=new WeakMap,c.set(Me,se));let le=se.get(H);le===void 0&&(le=i.getUniformBlockIndex(Me,H.name),se.set(H,le))}function Ye(H,Me){const le=c.get(Me).get(H);l.get(Me)!==le&&(i.uniformBlockBinding(Me,le,H.__bindingPointIndex),l.set(Me,le))}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),r.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),h={},ae=null,ce={},u={},d=new WeakMap,p=[],g=null,_=!1,m=null,f=null,M=null,S=null,b=null,F=null,L=null,A=new ft(0,0,0),U=0,E=!1,x=null,C=null,V=null,O=null,q=null,me.set(0,0,i.canvas.width,i.canvas.height),oe.set(0,0,i.canvas.width,i.canvas.height),o.reset(),r.reset(),a.reset()}return{buffers:{color:o,depth:r,stencil:a},enable:he,disable:Ie,bindFramebuffer:Be,drawBuffers:ke,useProgram:ht,setBlending:G,setMaterial:Kt,setFlipSided:et,setCullFace:nt,setLineWidth:We,setPolygonOffset:pt,setScissorTest:Ne,activeTexture:I,bindTexture:w,unbindTexture:Q,compressedTexImage2D:ne,compressedTexImage3D:j,texImage2D:xe,texImage3D:Oe,updateUBOMapping:ot,uniformBlockBinding:Ye,texStorage2D:Ze,texStorage3D:pe,texSubImage2D:ie,texSubImage3D:Se,compressedTexSubImage2D:ye,compressedTexSubImage3D:Ae,scissor:He,viewport:Ee,reset:mt}}function zf(i,e,t,n){const s=PI(n);switch(t){case vm:return i*e;case ym:return i*e;case xm:return i*e*2;case Mm:return i*e/s.components*s.byteLength;case $h:return i*e/s.components*s.byteLength;case Sm:return i*e*2/s.components*s.byteLength;case qh:return i*e*2/s.components*s.byteLength;case bm:return i*e*3/s.components*s.byteLength;case ci:return i*e*4/s.components*s.byteLength;case Xh:return i*e*4/s.components*s.byteLength;case Sa:case wa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ea:case Ta:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Oc:case Bc:return Math.max(i,16)*Math.max(e,8)/4;case Fc:case zc:return Math.max(i,8)*Math.max(e,8)/2;case Hc:case Vc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Gc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Wc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case $c:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case qc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Xc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case jc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Yc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Kc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Zc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Jc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Qc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case eh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case th:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case nh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case ih:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Aa:case sh:case oh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case wm:case rh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ah:case lh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function PI(i){switch(i){case qi:case mm:return{byteLength:1,components:1};case Er:case gm:case Cr:return{byteLength:2,components:1};case Gh:case Wh:return{byteLength:2,components:4};case Xs:case Vh:case zi:return{byteLength:4,components:1};case _m:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function LI(i,e,t,n,s,o,r){const a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new vt,h=new WeakMap;let u;const d=new WeakMap;let p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(I,w){return p?new OffscreenCanvas(I,w):Ga("canvas")}function _(I,w,Q){let ne=1;const j=Ne(I);if((j.width>Q||j.height>Q)&&(ne=Q/Math.max(j.width,j.height)),ne<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){const ie=Math.floor(ne*j.width),Se=Math.floor(ne*j.height);u===void 0&&(u=g(ie,Se));const ye=w?g(ie,Se):u;return ye.width=ie,ye.height=Se,ye.getContext("2d").drawImage(I,0,0,ie,Se),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+j.width+"x"+j.height+") to ("+ie+"x"+Se+")."),ye}else return"data"in I&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+j.width+"x"+j.height+")."),I;return I}function m(I){return I.generateMipmaps}function f(I){i.generateMipmap(I)}function M(I){return I.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?i.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(I,w,Q,ne,j=!1){if(I!==null){if(i[I]!==void 0)return i[I];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let ie=w;if(w===i.RED&&(Q===i.FLOAT&&(ie=i.R32F),Q===i.HALF_FLOAT&&(ie=i.R16F),Q===i.UNSIGNED_BYTE&&(ie=i.R8)),w===i.RED_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.R8UI),Q===i.UNSIGNED_SHORT&&(ie=i.R16UI),Q===i.UNSIGNED_INT&&(ie=i.R32UI),Q===i.BYTE&&(ie=i.R8I),Q===i.SHORT&&(ie=i.R16I),Q===i.INT&&(ie=i.R32I)),w===i.RG&&(Q===i.FLOAT&&(ie=i.RG32F),Q===i.HALF_FLOAT&&(ie=i.RG16F),Q===i.UNSIGNED_BYTE&&(ie=i.RG8)),w===i.RG_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.RG8UI),Q===i.UNSIGNED_SHORT&&(ie=i.RG16UI),Q===i.UNSIGNED_INT&&(ie=i.RG32UI),Q===i.BYTE&&(ie=i.RG8I),Q===i.SHORT&&(ie=i.RG16I),Q===i.INT&&(ie=i.RG32I)),w===i.RGB_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.RGB8UI),Q===i.UNSIGNED_SHORT&&(ie=i.RGB16UI),Q===i.UNSIGNED_INT&&(ie=i.RGB32UI),Q===i.BYTE&&(ie=i.RGB8I),Q===i.SHORT&&(ie=i.RGB16I),Q===i.INT&&(ie=i.RGB32I)),w===i.RGBA_INTEGER&&(Q===i.UNSIGNED_BYTE&&(ie=i.RGBA8UI),Q===i.UNSIGNED_SHORT&&(ie=i.RGBA16UI),Q===i.UNSIGNED_INT&&(ie=i.RGBA32UI),Q===i.BYTE&&(ie=i.RGBA8I),Q===i.SHORT&&(ie=i.RGBA16I),Q===i.INT&&(ie=i.RGBA32I)),w===i.RGB&&Q===i.UNSIGNED_INT_5_9_9_9_REV&&(ie=i.RGB9_E5),w===i.RGBA){const Se=j?nl:_t.getTransfer(ne);Q===i.FLOAT&&(ie=i.RGBA32F),Q===i.HALF_FLOAT&&(ie=i.RGBA16F),Q===i.UNSIGNED_BYTE&&(ie=Se===Rt?i.SRGB8_ALPHA8:i.RGBA8),Q===i.UNSIGNED_SHORT_4_4_4_4&&(ie=i.RGBA4),Q===i.UNSIGNED_SHORT_5_5_5_1&&(ie=i.RGB5_A1)}return(ie===i.R16F||ie===i.R32F||ie===i.RG16F||ie===i.RG32F||ie===i.RGBA16F||ie===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function b(I,w){let Q;return I?w===null||w===Xs||w===Ho?Q=i.DEPTH24_STENCIL8:w===zi?Q=i.DEPTH32F_STENCIL8:w===Er&&(Q=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Xs||w===Ho?Q=i.DEPTH_COMPONENT24:w===zi?Q=i.DEPTH_COMPONENT32F:w===Er&&(Q=i.DEPTH_COMPONENT16),Q}function F(I,w){return m(I)===!0||I.isFramebufferTexture&&I.minFilter!==hi&&I.minFilter!==xi?Math.log2(Math.max(w.width,w.height))+1:I.mipmaps!==void 0&&I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?w.mipmaps.length:1}function L(I){const w=I.target;w.removeEventListener("dispose",L),U(w),w.isVideoTexture&&h.delete(w)}function A(I){const w=I.target;w.removeEventListener("dispose",A),x(w)}function U(I){const w=n.get(I);if(w.__webglInit===void 0)return;const Q=I.source,ne=d.get(Q);if(ne){const j=ne[w.__cacheKey];j.usedTimes--,j.usedTimes===0&&E(I),Object.keys(ne).length===0&&d.delete(Q)}n.remove(I)}function E(I){const w=n.get(I);i.deleteTexture(w.__webglTexture);const Q=I.source,ne=d.get(Q);delete ne[w.__cacheKey],r.memory.textures--}function x(I){const w=n.get(I);if(I.depthTexture&&(I.depthTexture.dispose(),n.remove(I.depthTexture)),I.isWebGLCubeRenderTarget)for(let ne=0;ne<6;ne++){if(Array.isArray(w.__webglFramebuffer[ne]))for(let j=0;j<w.__webglFramebuffer[ne].length;j++)i.deleteFramebuffer(w.__webglFramebuffer[ne][j]);else i.deleteFramebuffer(w.__webglFramebuffer[ne]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[ne])}else{if(Array.isArray(w.__webglFramebuffer))for(let ne=0;ne<w.__webglFramebuffer.length;ne++)i.deleteFramebuffer(w.__webglFramebuffer[ne]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ne=0;ne<w.__webglColorRenderbuffer.length;ne++)w.__webglColorRenderbuffer[ne]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[ne]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}const Q=I.textures;for(let ne=0,j=Q.length;ne<j;ne++){const ie=n.get(Q[ne]);ie.__webglTexture&&(i.deleteTexture(ie.__webglTexture),r.memory.textures--),n.remove(Q[ne])}n.remove(I)}let C=0;function V(){C=0}function O(){const I=C;return I>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+I+" texture units while this GPU supports only "+s.maxTextures),C+=1,I}function q(I){const w=[];return w.push(I.wrapS),w.push(I.wrapT),w.push(I.wrapR||0),w.push(I.magFilter),w.push(I.minFilter),w.push(I.anisotropy),w.push(I.internalFormat),w.push(I.format),w.push(I.type),w.push(I.generateMipmaps),w.push(I.premultiplyAlpha),w.push(I.flipY),w.push(I.unpackAlignment),w.push(I.colorSpace),w.join()}function $(I,w){const Q=n.get(I);if(I.isVideoTexture&&We(I),I.isRenderTargetTexture===!1&&I.version>0&&Q.__version!==I.version){const ne=I.image;if(ne===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{oe(Q,I,w);return}}t.bindTexture(i.TEXTURE_2D,Q.__webglTexture,i.TEXTURE0+w)}function X(I,w){const Q=n.get(I);if(I.version>0&&Q.__version!==I.version){oe(Q,I,w);return}t.bindTexture(i.TEXTURE_2D_ARRAY,Q.__webglTexture,i.TEXTURE0+w)}function Y(I,w){const Q=n.get(I);if(I.version>0&&Q.__version!==I.version){oe(Q,I,w);return}t.bindTexture(i.TEXTURE_3D,Q.__webglTexture,i.TEXTURE0+w)}function ee(I,w){const Q=n.get(I);if(I.version>0&&Q.__version!==I.version){ue(Q,I,w);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Q.__webglTexture,i.TEXTURE0+w)}const ae={[Ha]:i.REPEAT,[Os]:i.CLAMP_TO_EDGE,[Uc]:i.MIRRORED_REPEAT},ce={[hi]:i.NEAREST,[v2]:i.NEAREST_MIPMAP_NEAREST,[Kr]:i.NEAREST_MIPMAP_LINEAR,[xi]:i.LINEAR,[Cl]:i.LINEAR_MIPMAP_NEAREST,[zs]:i.LINEAR_MIPMAP_LINEAR},_e={[M2]:i.NEVER,[R2]:i.ALWAYS,[S2]:i.LESS,[Tm]:i.LEQUAL,[w2]:i.EQUAL,[A2]:i.GEQUAL,[E2]:i.GREATER,[T2]:i.NOTEQUAL};function be(I,w){if(w.type===zi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===xi||w.magFilter===Cl||w.magFilter===Kr||w.magFilter===zs||w.minFilter===xi||w.minFilter===Cl||w.minFilter===Kr||w.minFilter===zs)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(I,i.TEXTURE_WRAP_S,ae[w.wrapS]),i.texParameteri(I,i.TEXTURE_WRAP_T,ae[w.wrapT]),(I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY)&&i.texParameteri(I,i.TEXTURE_WRAP_R,ae[w.wrapR]),i.texParameteri(I,i.TEXTURE_MAG_FILTER,ce[w.magFilter]),i.texParameteri(I,i.TEXTURE_MIN_FILTER,ce[w.minFilter]),w.compareFunction&&(i.texParameteri(I,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(I,i.TEXTURE_COMPARE_FUNC,_e[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===hi||w.minFilter!==Kr&&w.minFilter!==zs||w.type===zi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){const Q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(I,Q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function me(I,w){let Q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,w.addEventListener("dispose",L));const ne=w.source;let j=d.get(ne);j===void 0&&(j={},d.set(ne,j));const ie=q(w);if(ie!==I.__cacheKey){j[ie]===void 0&&(j[ie]={texture:i.createTexture(),usedTimes:0},r.memory.textures++,Q=!0),j[ie].usedTimes++;const Se=j[I.__cacheKey];Se!==void 0&&(j[I.__cacheKey].usedTimes--,Se.usedTimes===0&&E(w)),I.__cacheKey=ie,I.__webglTexture=j[ie].texture}return Q}function oe(I,w,Q){let ne=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(ne=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(ne=i.TEXTURE_3D);const j=me(I,w),ie=w.source;t.bindTexture(ne,I.__webglTexture,i.TEXTURE0+Q);const Se=n.get(ie);if(ie.version!==Se.__version||j===!0){t.activeTexture(i.TEXTURE0+Q);const ye=_t.getPrimaries(_t.workingColorSpace),Ae=w.colorSpace===as?null:_t.getPrimaries(w.colorSpace),Ze=w.colorSpace===as||ye===Ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ze);let pe=_(w.image,!1,s.maxTextureSize);pe=pt(w,pe);const xe=o.convert(w.format,w.colorSpace),Oe=o.convert(w.type);let He=S(w.internalFormat,xe,Oe,w.colorSpace,w.isVideoTexture);be(ne,w);let Ee;const ot=w.mipmaps,Ye=w.isVideoTexture!==!0,mt=Se.__version===void 0||j===!0,H=ie.dataReady,Me=F(w,pe);if(w.isDepthTexture)He=b(w.format===Vo,w.type),mt&&(Ye?t.texStorage2D(i.TEXTURE_2D,1,He,pe.width,pe.height):t.texImage2D(i.TEXTURE_2D,0,He,pe.width,pe.height,0,xe,Oe,null));else if(w.isDataTexture)if(ot.length>0){Ye&&mt&&t.texStorage2D(i.TEXTURE_2D,Me,He,ot[0].width,ot[0].height);for(let se=0,le=ot.length;se<le;se++)Ee=ot[se],Ye?H&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,Ee.width,Ee.height,xe,Oe,Ee.data):t.texImage2D(i.TEXTURE_2D,se,He,Ee.width,Ee.height,0,xe,Oe,Ee.data);w.generateMipmaps=!1}else Ye?(mt&&t.texStorage2D(i.TEXTURE_2D,Me,He,pe.width,pe.height),H&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe.width,pe.height,xe,Oe,pe.data)):t.texImage2D(i.TEXTURE_2D,0,He,pe.width,pe.height,0,xe,Oe,pe.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){Ye&&mt&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Me,He,ot[0].width,ot[0].height,pe.depth);for(let se=0,le=ot.length;se<le;se++)if(Ee=ot[se],w.format!==ci)if(xe!==null)if(Ye){if(H)if(w.layerUpdates.size>0){const Re=zf(Ee.width,Ee.height,w.format,w.type);for(const Ce of w.layerUpdates){const Qe=Ee.data.subarray(Ce*Re/Ee.data.BYTES_PER_ELEMENT,(Ce+1)*Re/Ee.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,Ce,Ee.width,Ee.height,1,xe,Qe)}w.clearLayerUpdates()}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,Ee.width,Ee.height,pe.depth,xe,Ee.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,se,He,Ee.width,Ee.height,pe.depth,0,Ee.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Ye?H&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,Ee.width,Ee.height,pe.depth,xe,Oe,Ee.data):t.texImage3D(i.TEXTURE_2D_ARRAY,se,He,Ee.width,Ee.height,pe.depth,0,xe,Oe,Ee.data)}else{Ye&&mt&&t.texStorage2D(i.TEXTURE_2D,Me,He,ot[0].width,ot[0].height);for(let se=0,le=ot.length;se<le;se++)Ee=ot[se],w.format!==ci?xe!==null?Ye?H&&t.compressedTexSubImage2D(i.TEXTURE_2D,se,0,0,Ee.width,Ee.height,xe,Ee.data):t.compressedTexImage2D(i.TEXTURE_2D,se,He,Ee.width,Ee.height,0,Ee.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Ye?H&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,Ee.width,Ee.height,xe,Oe,Ee.data):t.texImage2D(i.TEXTURE_2D,se,He,Ee.width,Ee.height,0,xe,Oe,Ee.data)}else if(w.isDataArrayTexture)if(Ye){if(mt&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Me,He,pe.width,pe.height,pe.depth),H)if(w.layerUpdates.size>0){const se=zf(pe.width,pe.height,w.format,w.type);for(const le of w.layerUpdates){const Re=pe.data.subarray(le*se/pe.data.BYTES_PER_ELEMENT,(le+1)*se/pe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,le,pe.width,pe.height,1,xe,Oe,Re)}w.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,pe.width,pe.height,pe.depth,xe,Oe,pe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,He,pe.width,pe.height,pe.depth,0,xe,Oe,pe.data);else if(w.isData3DTexture)Ye?(mt&&t.texStorage3D(i.TEXTURE_3D,Me,He,pe.width,pe.height,pe.depth),H&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,pe.width,pe.height,pe.depth,xe,Oe,pe.data)):t.texImage3D(i.TEXTURE_3D,0,He,pe.width,pe.height,pe.depth,0,xe,Oe,pe.data);else if(w.isFramebufferTexture){if(mt)if(Ye)t.texStorage2D(i.TEXTURE_2D,Me,He,pe.width,pe.height);else{let se=pe.width,le=pe.height;for(let Re=0;Re<Me;Re++)t.texImage2D(i.TEXTURE_2D,Re,He,se,le,0,xe,Oe,null),se>>=1,le>>=1}}else if(ot.length>0){if(Ye&&mt){const se=Ne(ot[0]);t.texStorage2D(i.TEXTURE_2D,Me,He,se.width,se.height)}for(let se=0,le=ot.length;se<le;se++)Ee=ot[se],Ye?H&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,xe,Oe,Ee):t.texImage2D(i.TEXTURE_2D,se,He,xe,Oe,Ee);w.generateMipmaps=!1}else if(Ye){if(mt){const se=Ne(pe);t.texStorage2D(i.TEXTURE_2D,Me,He,se.width,se.height)}H&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,xe,Oe,pe)}else t.texImage2D(i.TEXTURE_2D,0,He,xe,Oe,pe);m(w)&&f(ne),Se.__version=ie.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function ue(I,w,Q){if(w.image.length!==6)return;const ne=me(I,w),j=w.source;t.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+Q);const ie=n.get(j);if(j.version!==ie.__version||ne===!0){t.activeTexture(i.TEXTURE0+Q);const Se=_t.getPrimaries(_t.workingColorSpace),ye=w.colorSpace===as?null:_t.getPrimaries(w.colorSpace),Ae=w.colorSpace===as||Se===ye?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ae);const Ze=w.isCompressedTexture||w.image[0].isCompressedTexture,pe=w.image[0]&&w.image[0].isDataTexture,xe=[];for(let le=0;le<6;le++)!Ze&&!pe?xe[le]=_(w.image[le],!0,s.maxCubemapSize):xe[le]=pe?w.image[le].image:w.image[le],xe[le]=pt(w,xe[le]);const Oe=xe[0],He=o.convert(w.format,w.colorSpace),Ee=o.convert(w.type),ot=S(w.internalFormat,He,Ee,w.colorSpace),Ye=w.isVideoTexture!==!0,mt=ie.__version===void 0||ne===!0,H=j.dataReady;let Me=F(w,Oe);be(i.TEXTURE_CUBE_MAP,w);let se;if(Ze){Ye&&mt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Me,ot,Oe.width,Oe.height);for(let le=0;le<6;le++){se=xe[le].mipmaps;for(let Re=0;Re<se.length;Re++){const Ce=se[Re];w.format!==ci?He!==null?Ye?H&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re,0,0,Ce.width,Ce.height,He,Ce.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re,ot,Ce.width,Ce.height,0,Ce.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ye?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re,0,0,Ce.width,Ce.height,He,Ee,Ce.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re,ot,Ce.width,Ce.height,0,He,Ee,Ce.data)}}}else{if(se=w.mipmaps,Ye&&mt){se.length>0&&Me++;const le=Ne(xe[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Me,ot,le.width,le.height)}for(let le=0;le<6;le++)if(pe){Ye?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,0,0,0,xe[le].width,xe[le].height,He,Ee,xe[le].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,0,ot,xe[le].width,xe[le].height,0,He,Ee,xe[le].data);for(let Re=0;Re<se.length;Re++){const Qe=se[Re].image[le].image;Ye?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re+1,0,0,Qe.width,Qe.height,He,Ee,Qe.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re+1,ot,Qe.width,Qe.height,0,He,Ee,Qe.data)}}else{Ye?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,0,0,0,He,Ee,xe[le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,0,ot,He,Ee,xe[le]);for(let Re=0;Re<se.length;Re++){const Ce=se[Re];Ye?H&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re+1,0,0,He,Ee,Ce.image[le]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+le,Re+1,ot,He,Ee,Ce.image[le])}}}m(w)&&f(i.TEXTURE_CUBE_MAP),ie.__version=j.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function ve(I,w,Q,ne,j,ie){const Se=o.convert(Q.format,Q.colorSpace),ye=o.convert(Q.type),Ae=S(Q.internalFormat,Se,ye,Q.colorSpace),Ze=n.get(w),pe=n.get(Q);if(pe.__renderTarget=w,!Ze.__hasExternalTextures){const xe=Math.max(1,w.width>>ie),Oe=Math.max(1,w.height>>ie);j===i.TEXTURE_3D||j===i.TEXTURE_2D_ARRAY?t.texImage3D(j,ie,Ae,xe,Oe,w.depth,0,Se,ye,null):t.texImage2D(j,ie,Ae,xe,Oe,0,Se,ye,null)}t.bindFramebuffer(i.FRAMEBUFFER,I),nt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ne,j,pe.__webglTexture,0,et(w)):(j===i.TEXTURE_2D||j>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&j<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ne,j,pe.__webglTexture,ie),t.bindFramebuffer(i.FRAMEBUFFER,null)}function he(I,w,Q){if(i.bindRenderbuffer(i.RENDERBUFFER,I),w.depthBuffer){const ne=w.depthTexture,j=ne&&ne.isDepthTexture?ne.type:null,ie=b(w.stencilBuffer,j),Se=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=et(w);nt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ye,ie,w.width,w.height):Q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ye,ie,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ie,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Se,i.RENDERBUFFER,I)}else{const ne=w.textures;for(let j=0;j<ne.length;j++){const ie=ne[j],Se=o.convert(ie.format,ie.colorSpace),ye=o.convert(ie.type),Ae=S(ie.internalFormat,Se,ye,ie.colorSpace),Ze=et(w);Q&&nt(w)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ze,Ae,w.width,w.height):nt(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ze,Ae,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,Ae,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ie(I,w){if(w&&w.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(i.FRAMEBUFFER,I),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const ne=n.get(w.depthTexture);ne.__renderTarget=w,(!ne.__webglTexture||w.depthTexture.image.width!==w.width||w.depthTexture.image.height!==w.height)&&(w.depthTexture.image.width=w.width,w.depthTexture.image.height=w.height,w.depthTexture.needsUpdate=!0),$(w.depthTexture,0);const j=ne.__webglTexture,ie=et(w);if(w.depthTexture.format===No)nt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,j,0);else if(w.depthTexture.format===Vo)nt(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0,ie):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,j,0);else throw new Error("Unknown depthTexture format")}function Be(I){const w=n.get(I),Q=I.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==I.depthTexture){const ne=I.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),ne){const j=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,ne.removeEventListener("dispose",j)};ne.addEventListener("dispose",j),w.__depthDisposeCallback=j}w.__boundDepthTexture=ne}if(I.depthTexture&&!w.__autoAllocateDepthBuffer){if(Q)throw new Error("target.depthTexture not supported in Cube render targets");Ie(w.__webglFramebuffer,I)}else if(Q){w.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[ne]),w.__webglDepthbuffer[ne]===void 0)w.__webglDepthbuffer[ne]=i.createRenderbuffer(),he(w.__webglDepthbuffer[ne],I,!1);else{const j=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ie=w.__webglDepthbuffer[ne];i.bindRenderbuffer(i.RENDERBUFFER,ie),i.framebufferRenderbuffer(i.FRAMEBUFFER,j,i.RENDERBUFFER,ie)}}else if(t.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),he(w.__webglDepthbuffer,I,!1);else{const ne=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,j=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,j),i.framebufferRenderbuffer(i.FRAMEBUFFER,ne,i.RENDERBUFFER,j)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function ke(I,w,Q){const ne=n.get(I);w!==void 0&&ve(ne.__webglFramebuffer,I,I.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Q!==void 0&&Be(I)}function ht(I){const w=I.texture,Q=n.get(I),ne=n.get(w);I.addEventListener("dispose",A);const j=I.textures,ie=I.isWebGLCubeRenderTarget===!0,Se=j.length>1;if(Se||(ne.__webglTexture===void 0&&(ne.__webglTexture=i.createTexture()),ne.__version=w.version,r.memory.textures++),ie){Q.__webglFramebuffer=[];for(let ye=0;ye<6;ye++)if(w.mipmaps&&w.mipmaps.length>0){Q.__webglFramebuffer[ye]=[];for(let Ae=0;Ae<w.mipmaps.length;Ae++)Q.__webglFramebuffer[ye][Ae]=i.createFramebuffer()}else Q.__webglFramebuffer[ye]=i.createFramebuffer()}else{if(w.mipmaps&&w.mipmaps.length>0){Q.__webglFramebuffer=[];for(let ye=0;ye<w.mipmaps.length;ye++)Q.__webglFramebuffer[ye]=i.createFramebuffer()}else Q.__webglFramebuffer=i.createFramebuffer();if(Se)for(let ye=0,Ae=j.length;ye<Ae;ye++){const Ze=n.get(j[ye]);Ze.__webglTexture===void 0&&(Ze.__webglTexture=i.createTexture(),r.memory.textures++)}if(I.samples>0&&nt(I)===!1){Q.__webglMultisampledFramebuffer=i.createFramebuffer(),Q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Q.__webglMultisampledFramebuffer);for(let ye=0;ye<j.length;ye++){const Ae=j[ye];Q.__webglColorRenderbuffer[ye]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Q.__webglColorRenderbuffer[ye]);const Ze=o.convert(Ae.format,Ae.colorSpace),pe=o.convert(Ae.type),xe=S(Ae.internalFormat,Ze,pe,Ae.colorSpace,I.isXRRenderTarget===!0),Oe=et(I);i.renderbufferStorageMultisample(i.RENDERBUFFER,Oe,xe,I.width,I.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.RENDERBUFFER,Q.__webglColorRenderbuffer[ye])}i.bindRenderbuffer(i.RENDERBUFFER,null),I.depthBuffer&&(Q.__webglDepthRenderbuffer=i.createRenderbuffer(),he(Q.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ie){t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),be(i.TEXTURE_CUBE_MAP,w);for(let ye=0;ye<6;ye++)if(w.mipmaps&&w.mipmaps.length>0)for(let Ae=0;Ae<w.mipmaps.length;Ae++)ve(Q.__webglFramebuffer[ye][Ae],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ye,Ae);else ve(Q.__webglFramebuffer[ye],I,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ye,0);m(w)&&f(i.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Se){for(let ye=0,Ae=j.length;ye<Ae;ye++){const Ze=j[ye],pe=n.get(Ze);t.bindTexture(i.TEXTURE_2D,pe.__webglTexture),be(i.TEXTURE_2D,Ze),ve(Q.__webglFramebuffer,I,Ze,i.COLOR_ATTACHMENT0+ye,i.TEXTURE_2D,0),m(Ze)&&f(i.TEXTURE_2D)}t.unbindTexture()}else{let ye=i.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(ye=I.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ye,ne.__webglTexture),be(ye,w),w.mipmaps&&w.mipmaps.length>0)for(let Ae=0;Ae<w.mipmaps.length;Ae++)ve(Q.__webglFramebuffer[Ae],I,w,i.COLOR_ATTACHMENT0,ye,Ae);else ve(Q.__webglFramebuffer,I,w,i.COLOR_ATTACHMENT0,ye,0);m(w)&&f(ye),t.unbindTexture()}I.depthBuffer&&Be(I)}function Je(I){const w=I.textures;for(let Q=0,ne=w.length;Q<ne;Q++){const j=w[Q];if(m(j)){const ie=M(I),Se=n.get(j).__webglTexture;t.bindTexture(ie,Se),f(ie),t.unbindTexture()}}}const ut=[],G=[];function Kt(I){if(I.samples>0){if(nt(I)===!1){const w=I.textures,Q=I.width,ne=I.height;let j=i.COLOR_BUFFER_BIT;const ie=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=n.get(I),ye=w.length>1;if(ye)for(let Ae=0;Ae<w.length;Ae++)t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let Ae=0;Ae<w.length;Ae++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(j|=i.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(j|=i.STENCIL_BUFFER_BIT)),ye){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Se.__webglColorRenderbuffer[Ae]);const Ze=n.get(w[Ae]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Ze,0)}i.blitFramebuffer(0,0,Q,ne,0,0,Q,ne,j,i.NEAREST),l===!0&&(ut.length=0,G.length=0,ut.push(i.COLOR_ATTACHMENT0+Ae),I.depthBuffer&&I.resolveDepthBuffer===!1&&(ut.push(ie),G.push(ie),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,G)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ut))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ye)for(let Ae=0;Ae<w.length;Ae++){t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.RENDERBUFFER,Se.__webglColorRenderbuffer[Ae]);const Ze=n.get(w[Ae]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Se.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Ae,i.TEXTURE_2D,Ze,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.resolveDepthBuffer===!1&&l){const w=I.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function et(I){return Math.min(s.maxSamples,I.samples)}function nt(I){const w=n.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function We(I){const w=r.render.frame;h.get(I)!==w&&(h.set(I,w),I.update())}function pt(I,w){const Q=I.colorSpace,ne=I.format,j=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||Q!==Yo&&Q!==as&&(_t.getTransfer(Q)===Rt?(ne!==ci||j!==qi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Q)),w}function Ne(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=O,this.resetTextureUnits=V,this.setTexture2D=$,this.setTexture2DArray=X,this.setTexture3D=Y,this.setTextureCube=ee,this.rebindTextures=ke,this.setupRenderTarget=ht,this.updateRenderTargetMipmap=Je,this.updateMultisampleRenderTarget=Kt,this.setupDepthRenderbuffer=Be,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=nt}function NI(i,e){function t(n,s=as){let o;const r=_t.getTransfer(s);if(n===qi)return i.UNSIGNED_BYTE;if(n===Gh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Wh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===_m)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===mm)return i.BYTE;if(n===gm)return i.SHORT;if(n===Er)return i.UNSIGNED_SHORT;if(n===Vh)return i.INT;if(n===Xs)return i.UNSIGNED_INT;if(n===zi)return i.FLOAT;if(n===Cr)return i.HALF_FLOAT;if(n===vm)return i.ALPHA;if(n===bm)return i.RGB;if(n===ci)return i.RGBA;if(n===ym)return i.LUMINANCE;if(n===xm)return i.LUMINANCE_ALPHA;if(n===No)return i.DEPTH_COMPONENT;if(n===Vo)return i.DEPTH_STENCIL;if(n===Mm)return i.RED;if(n===$h)return i.RED_INTEGER;if(n===Sm)return i.RG;if(n===qh)return i.RG_INTEGER;if(n===Xh)return i.RGBA_INTEGER;if(n===Sa||n===wa||n===Ea||n===Ta)if(r===Rt)if(o=e.get("WEBGL_compressed_texture_s3tc_srgb"),o!==null){if(n===Sa)return o.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===wa)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ea)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ta)return o.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(o=e.get("WEBGL_compressed_texture_s3tc"),o!==null){if(n===Sa)return o.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===wa)return o.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ea)return o.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ta)return o.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Fc||n===Oc||n===zc||n===Bc)if(o=e.get("WEBGL_compressed_texture_pvrtc"),o!==null){if(n===Fc)return o.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Oc)return o.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===zc)return o.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Bc)return o.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Hc||n===Vc||n===Gc)if(o=e.get("WEBGL_compressed_texture_etc"),o!==null){if(n===Hc||n===Vc)return r===Rt?o.COMPRESSED_SRGB8_ETC2:o.COMPRESSED_RGB8_ETC2;if(n===Gc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:o.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Wc||n===$c||n===qc||n===Xc||n===jc||n===Yc||n===Kc||n===Zc||n===Jc||n===Qc||n===eh||n===th||n===nh||n===ih)if(o=e.get("WEBGL_compressed_texture_astc"),o!==null){if(n===Wc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:o.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===$c)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:o.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===qc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:o.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Xc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:o.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===jc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:o.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Yc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:o.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Kc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:o.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Zc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:o.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Jc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:o.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Qc)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:o.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===eh)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:o.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===th)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:o.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===nh)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:o.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ih)return r===Rt?o.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:o.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Aa||n===sh||n===oh)if(o=e.get("EXT_texture_compression_bptc"),o!==null){if(n===Aa)return r===Rt?o.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:o.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===sh)return o.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===oh)return o.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===wm||n===rh||n===ah||n===lh)if(o=e.get("EXT_texture_compression_rgtc"),o!==null){if(n===Aa)return o.COMPRESSED_RED_RGTC1_EXT;if(n===rh)return o.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ah)return o.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===lh)return o.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ho?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}class DI extends Kn{constructor(e=[]){super(),this.isArrayCamera=!0,this.cameras=e}}class Mi extends pn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const II={type:"move"};class sc{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Mi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Mi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new te,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new te),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Mi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new te,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new te),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,o=null,r=null;const a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){r=!0;for(const _ of e.hand.values()){const m=t.getJointPose(_,n),f=this._getHandJoint(c,_);m!==null&&(f.matrix.fromArray(m.transform.matrix),f.matrix.decompose(f.position,f.rotation,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=m.radius),f.visible=m!==null}const h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),p=.02,g=.005;c.inputState.pinching&&d>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(o=t.getPose(e.gripSpace,n),o!==null&&(l.matrix.fromArray(o.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,o.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(o.linearVelocity)):l.hasLinearVelocity=!1,o.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(o.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&o!==null&&(s=o),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(II)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=o!==null),c!==null&&(c.visible=r!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const n=new Mi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}}const kI=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,UI=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class FI{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t,n){if(this.texture===null){const s=new Tn,o=e.properties.get(s);o.__webglTexture=t.texture,(t.depthNear!=n.depthNear||t.depthFar!=n.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=s}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,n=new gs({vertexShader:kI,fragmentShader:UI,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new dn(new Ir(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class OI extends Ko{constructor(e,t){super();const n=this;let s=null,o=1,r=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,p=null,g=null;const _=new FI,m=t.getContextAttributes();let f=null,M=null;const S=[],b=[],F=new vt;let L=null;const A=new Kn;A.viewport=new Wt;const U=new Kn;U.viewport=new Wt;const E=[A,U],x=new DI;let C=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(oe){let ue=S[oe];return ue===void 0&&(ue=new sc,S[oe]=ue),ue.getTargetRaySpace()},this.getControllerGrip=function(oe){let ue=S[oe];return ue===void 0&&(ue=new sc,S[oe]=ue),ue.getGripSpace()},this.getHand=function(oe){let ue=S[oe];return ue===void 0&&(ue=new sc,S[oe]=ue),ue.getHandSpace()};function O(oe){const ue=b.indexOf(oe.inputSource);if(ue===-1)return;const ve=S[ue];ve!==void 0&&(ve.update(oe.inputSource,oe.frame,c||r),ve.dispatchEvent({type:oe.type,data:oe.inputSource}))}function q(){s.removeEventListener("select",O),s.removeEventListener("selectstart",O),s.removeEventListener("selectend",O),s.removeEventListener("squeeze",O),s.removeEventListener("squeezestart",O),s.removeEventListener("squeezeend",O),s.removeEventListener("end",q),s.removeEventListener("inputsourceschange",$);for(let oe=0;oe<S.length;oe++){const ue=b[oe];ue!==null&&(b[oe]=null,S[oe].disconnect(ue))}C=null,V=null,_.reset(),e.setRenderTarget(f),p=null,d=null,u=null,s=null,M=null,me.stop(),n.isPresenting=!1,e.setPixelRatio(L),e.setSize(F.width,F.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(oe){o=oe,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(oe){a=oe,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||r},this.setReferenceSpace=function(oe){c=oe},this.getBaseLayer=function(){return d!==null?d:p},this.getBinding=function(){return u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(oe){if(s=oe,s!==null){if(f=e.getRenderTarget(),s.addEventListener("select",O),s.addEventListener("selectstart",O),s.addEventListener("selectend",O),s.addEventListener("squeeze",O),s.addEventListener("squeezestart",O),s.addEventListener("squeezeend",O),s.addEventListener("end",q),s.addEventListener("inputsourceschange",$),m.xrCompatible!==!0&&await t.makeXRCompatible(),L=e.getPixelRatio(),e.getSize(F),s.renderState.layers===void 0){const ue={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:o};p=new XRWebGLLayer(s,t,ue),s.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new js(p.framebufferWidth,p.framebufferHeight,{format:ci,type:qi,colorSpace:e.outputColorSpace,stencilBuffer:m.stencil})}else{let ue=null,ve=null,he=null;m.depth&&(he=m.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ue=m.stencil?Vo:No,ve=m.stencil?Ho:Xs);const Ie={colorFormat:t.RGBA8,depthFormat:he,scaleFactor:o};u=new XRWebGLBinding(s,t),d=u.createProjectionLayer(Ie),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new js(d.textureWidth,d.textureHeight,{format:ci,type:qi,depthTexture:new zm(d.textureWidth,d.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,ue),stencilBuffer:m.stencil,colorSpace:e.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,r=await s.requestReferenceSpace(a),me.setContext(s),me.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function $(oe){for(let ue=0;ue<oe.removed.length;ue++){const ve=oe.removed[ue],he=b.indexOf(ve);he>=0&&(b[he]=null,S[he].disconnect(ve))}for(let ue=0;ue<oe.added.length;ue++){const ve=oe.added[ue];let he=b.indexOf(ve);if(he===-1){for(let Be=0;Be<S.length;Be++)if(Be>=b.length){b.push(ve),he=Be;break}else if(b[Be]===null){b[Be]=ve,he=Be;break}if(he===-1)break}const Ie=S[he];Ie&&Ie.connect(ve)}}const X=new te,Y=new te;function ee(oe,ue,ve){X.setFromMatrixPosition(ue.matrixWorld),Y.setFromMatrixPosition(ve.matrixWorld);const he=X.distanceTo(Y),Ie=ue.projectionMatrix.elements,Be=ve.projectionMatrix.elements,ke=Ie[14]/(Ie[10]-1),ht=Ie[14]/(Ie[10]+1),Je=(Ie[9]+1)/Ie[5],ut=(Ie[9]-1)/Ie[5],G=(Ie[8]-1)/Ie[0],Kt=(Be[8]+1)/Be[0],et=ke*G,nt=ke*Kt,We=he/(-G+Kt),pt=We*-G;if(ue.matrixWorld.decompose(oe.position,oe.quaternion,oe.scale),oe.translateX(pt),oe.translateZ(We),oe.matrixWorld.compose(oe.position,oe.quaternion,oe.scale),oe.matrixWorldInverse.copy(oe.matrixWorld).invert(),Ie[10]===-1)oe.projectionMatrix.copy(ue.projectionMatrix),oe.projectionMatrixInverse.copy(ue.projectionMatrixInverse);else{const Ne=ke+We,I=ht+We,w=et-pt,Q=nt+(he-pt),ne=Je*ht/I*Ne,j=ut*ht/I*Ne;oe.projectionMatrix.makePerspective(w,Q,ne,j,Ne,I),oe.projectionMatrixInverse.copy(oe.projectionMatrix).invert()}}function ae(oe,ue){ue===null?oe.matrixWorld.copy(oe.matrix):oe.matrixWorld.multiplyMatrices(ue.matrixWorld,oe.matrix),oe.matrixWorldInverse.copy(oe.matrixWorld).invert()}this.updateCamera=function(oe){if(s===null)return;let ue=oe.near,ve=oe.far;_.texture!==null&&(_.depthNear>0&&(ue=_.depthNear),_.depthFar>0&&(ve=_.depthFar)),x.near=U.near=A.near=ue,x.far=U.far=A.far=ve,(C!==x.near||V!==x.far)&&(s.updateRenderState({depthNear:x.near,depthFar:x.far}),C=x.near,V=x.far),A.layers.mask=oe.layers.mask|2,U.layers.mask=oe.layers.mask|4,x.layers.mask=A.layers.mask|U.layers.mask;const he=oe.parent,Ie=x.cameras;ae(x,he);for(let Be=0;Be<Ie.length;Be++)ae(Ie[Be],he);Ie.length===2?ee(x,A,U):x.projectionMatrix.copy(A.projectionMatrix),ce(oe,x,he)};function ce(oe,ue,ve){ve===null?oe.matrix.copy(ue.matrixWorld):(oe.matrix.copy(ve.matrixWorld),oe.matrix.invert(),oe.matrix.multiply(ue.matrixWorld)),oe.matrix.decompose(oe.position,oe.quaternion,oe.scale),oe.updateMatrixWorld(!0),oe.projectionMatrix.copy(ue.projectionMatrix),oe.projectionMatrixInverse.copy(ue.projectionMatrixInverse),oe.isPerspectiveCamera&&(oe.fov=ch*2*Math.atan(1/oe.projectionMatrix.elements[5]),oe.zoom=1)}this.getCamera=function(){return x},this.getFoveation=function(){if(!(d===null&&p===null))return l},this.setFoveation=function(oe){l=oe,d!==null&&(d.fixedFoveation=oe),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=oe)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(x)};let _e=null;function be(oe,ue){if(h=ue.getViewerPose(c||r),g=ue,h!==null){const ve=h.views;p!==null&&(e.setRenderTargetFramebuffer(M,p.framebuffer),e.setRenderTarget(M));let he=!1;ve.length!==x.cameras.length&&(x.cameras.length=0,he=!0);for(let Be=0;Be<ve.length;Be++){const ke=ve[Be];let ht=null;if(p!==null)ht=p.getViewport(ke);else{const ut=u.getViewSubImage(d,ke);ht=ut.viewport,Be===0&&(e.setRenderTargetTextures(M,ut.colorTexture,d.ignoreDepthValues?void 0:ut.depthStencilTexture),e.setRenderTarget(M))}let Je=E[Be];Je===void 0&&(Je=new Kn,Je.layers.enable(Be),Je.viewport=new Wt,E[Be]=Je),Je.matrix.fromArray(ke.transform.matrix),Je.matrix.decompose(Je.position,Je.quaternion,Je.scale),Je.projectionMatrix.fromArray(ke.projectionMatrix),Je.projectionMatrixInverse.copy(Je.projectionMatrix).invert(),Je.viewport.set(ht.x,ht.y,ht.width,ht.height),Be===0&&(x.matrix.copy(Je.matrix),x.matrix.decompose(x.position,x.quaternion,x.scale)),he===!0&&x.cameras.push(Je)}const Ie=s.enabledFeatures;if(Ie&&Ie.includes("depth-sensing")){const Be=u.getDepthInformation(ve[0]);Be&&Be.isValid&&Be.texture&&_.init(e,Be,s.renderState)}}for(let ve=0;ve<S.length;ve++){const he=b[ve],Ie=S[ve];he!==null&&Ie!==void 0&&Ie.update(he,ue,c||r)}_e&&_e(oe,ue),ue.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ue}),g=null}const me=new Fm;me.setAnimationLoop(be),this.setAnimationLoop=function(oe){_e=oe},this.dispose=function(){}}}const Cs=new Ti,zI=new Ht;function BI(i,e){function t(m,f){m.matrixAutoUpdate===!0&&m.updateMatrix(),f.value.copy(m.matrix)}function n(m,f){f.color.getRGB(m.fogColor.value,Im(i)),f.isFog?(m.fogNear.value=f.near,m.fogFar.value=f.far):f.isFogExp2&&(m.fogDensity.value=f.density)}function s(m,f,M,S,b){f.isMeshBasicMaterial||f.isMeshLambertMaterial?o(m,f):f.isMeshToonMaterial?(o(m,f),u(m,f)):f.isMeshPhongMaterial?(o(m,f),h(m,f)):f.isMeshStandardMaterial?(o(m,f),d(m,f),f.isMeshPhysicalMaterial&&p(m,f,b)):f.isMeshMatcapMaterial?(o(m,f),g(m,f)):f.isMeshDepthMaterial?o(m,f):f.isMeshDistanceMaterial?(o(m,f),_(m,f)):f.isMeshNormalMaterial?o(m,f):f.isLineBasicMaterial?(r(m,f),f.isLineDashedMaterial&&a(m,f)):f.isPointsMaterial?l(m,f,M,S):f.isSpriteMaterial?c(m,f):f.isShadowMaterial?(m.color.value.copy(f.color),m.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function o(m,f){m.opacity.value=f.opacity,f.color&&m.diffuse.value.copy(f.color),f.emissive&&m.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(m.map.value=f.map,t(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,t(f.alphaMap,m.alphaMapTransform)),f.bumpMap&&(m.bumpMap.value=f.bumpMap,t(f.bumpMap,m.bumpMapTransform),m.bumpScale.value=f.bumpScale,f.side===Ln&&(m.bumpScale.value*=-1)),f.normalMap&&(m.normalMap.value=f.normalMap,t(f.normalMap,m.normalMapTransform),m.normalScale.value.copy(f.normalScale),f.side===Ln&&m.normalScale.value.negate()),f.displacementMap&&(m.displacementMap.value=f.displacementMap,t(f.displacementMap,m.displacementMapTransform),m.displacementScale.value=f.displacementScale,m.displacementBias.value=f.displacementBias),f.emissiveMap&&(m.emissiveMap.value=f.emissiveMap,t(f.emissiveMap,m.emissiveMapTransform)),f.specularMap&&(m.specularMap.value=f.specularMap,t(f.specularMap,m.specularMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest);const M=e.get(f),S=M.envMap,b=M.envMapRotation;S&&(m.envMap.value=S,Cs.copy(b),Cs.x*=-1,Cs.y*=-1,Cs.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Cs.y*=-1,Cs.z*=-1),m.envMapRotation.value.setFromMatrix4(zI.makeRotationFromEuler(Cs)),m.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=f.reflectivity,m.ior.value=f.ior,m.refractionRatio.value=f.refractionRatio),f.lightMap&&(m.lightMap.value=f.lightMap,m.lightMapIntensity.value=f.lightMapIntensity,t(f.lightMap,m.lightMapTransform)),f.aoMap&&(m.aoMap.value=f.aoMap,m.aoMapIntensity.value=f.aoMapIntensity,t(f.aoMap,m.aoMapTransform))}function r(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,f.map&&(m.map.value=f.map,t(f.map,m.mapTransform))}function a(m,f){m.dashSize.value=f.dashSize,m.totalSize.value=f.dashSize+f.gapSize,m.scale.value=f.scale}function l(m,f,M,S){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.size.value=f.size*M,m.scale.value=S*.5,f.map&&(m.map.value=f.map,t(f.map,m.uvTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,t(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function c(m,f){m.diffuse.value.copy(f.color),m.opacity.value=f.opacity,m.rotation.value=f.rotation,f.map&&(m.map.value=f.map,t(f.map,m.mapTransform)),f.alphaMap&&(m.alphaMap.value=f.alphaMap,t(f.alphaMap,m.alphaMapTransform)),f.alphaTest>0&&(m.alphaTest.value=f.alphaTest)}function h(m,f){m.specular.value.copy(f.specular),m.shininess.value=Math.max(f.shininess,1e-4)}function u(m,f){f.gradientMap&&(m.gradientMap.value=f.gradientMap)}function d(m,f){m.metalness.value=f.metalness,f.metalnessMap&&(m.metalnessMap.value=f.metalnessMap,t(f.metalnessMap,m.metalnessMapTransform)),m.roughness.value=f.roughness,f.roughnessMap&&(m.roughnessMap.value=f.roughnessMap,t(f.roughnessMap,m.roughnessMapTransform)),f.envMap&&(m.envMapIntensity.value=f.envMapIntensity)}function p(m,f,M){m.ior.value=f.ior,f.sheen>0&&(m.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),m.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(m.sheenColorMap.value=f.sheenColorMap,t(f.sheenColorMap,m.sheenColorMapTransform)),f.sheenRoughnessMap&&(m.sheenRoughnessMap.value=f.sheenRoughnessMap,t(f.sheenRoughnessMap,m.sheenRoughnessMapTransform))),f.clearcoat>0&&(m.clearcoat.value=f.clearcoat,m.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(m.clearcoatMap.value=f.clearcoatMap,t(f.clearcoatMap,m.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,t(f.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(m.clearcoatNormalMap.value=f.clearcoatNormalMap,t(f.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===Ln&&m.clearcoatNormalScale.value.negate())),f.dispersion>0&&(m.dispersion.value=f.dispersion),f.iridescence>0&&(m.iridescence.value=f.iridescence,m.iridescenceIOR.value=f.iridescenceIOR,m.iridescenceThicknessMinimum.value=f.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=f.iridescenceThicknessRange[1],f.iridescenceMap&&(m.iridescenceMap.value=f.iridescenceMap,t(f.iridescenceMap,m.iridescenceMapTransform)),f.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=f.iridescenceThicknessMap,t(f.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),f.transmission>0&&(m.transmission.value=f.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),f.transmissionMap&&(m.transmissionMap.value=f.transmissionMap,t(f.transmissionMap,m.transmissionMapTransform)),m.thickness.value=f.thickness,f.thicknessMap&&(m.thicknessMap.value=f.thicknessMap,t(f.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=f.attenuationDistance,m.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(m.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(m.anisotropyMap.value=f.anisotropyMap,t(f.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=f.specularIntensity,m.specularColor.value.copy(f.specularColor),f.specularColorMap&&(m.specularColorMap.value=f.specularColorMap,t(f.specularColorMap,m.specularColorMapTransform)),f.specularIntensityMap&&(m.specularIntensityMap.value=f.specularIntensityMap,t(f.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,f){f.matcap&&(m.matcap.value=f.matcap)}function _(m,f){const M=e.get(f).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function HI(i,e,t,n){let s={},o={},r=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(M,S){const b=S.program;n.uniformBlockBinding(M,b)}function c(M,S){let b=s[M.id];b===void 0&&(g(M),b=h(M),s[M.id]=b,M.addEventListener("dispose",m));const F=S.program;n.updateUBOMapping(M,F);const L=e.render.frame;o[M.id]!==L&&(d(M),o[M.id]=L)}function h(M){const S=u();M.__bindingPointIndex=S;const b=i.createBuffer(),F=M.__size,L=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,b),i.bufferData(i.UNIFORM_BUFFER,F,L),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,S,b),b}function u(){for(let M=0;M<a;M++)if(r.indexOf(M)===-1)return r.push(M),M;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(M){const S=s[M.id],b=M.uniforms,F=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let L=0,A=b.length;L<A;L++){const U=Array.isArray(b[L])?b[L]:[b[L]];for(let E=0,x=U.length;E<x;E++){const C=U[E];if(p(C,L,E,F)===!0){const V=C.__offset,O=Array.isArray(C.value)?C.value:[C.value];let q=0;for(let $=0;$<O.length;$++){const X=O[$],Y=_(X);typeof X=="number"||typeof X=="boolean"?(C.__data[0]=X,i.bufferSubData(i.UNIFORM_BUFFER,V+q,C.__data)):X.isMatrix3?(C.__data[0]=X.elements[0],C.__data[1]=X.elements[1],C.__data[2]=X.elements[2],C.__data[3]=0,C.__data[4]=X.elements[3],C.__data[5]=X.elements[4],C.__data[6]=X.elements[5],C.__data[7]=0,C.__data[8]=X.elements[6],C.__data[9]=X.elements[7],C.__data[10]=X.elements[8],C.__data[11]=0):(X.toArray(C.__data,q),q+=Y.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,V,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(M,S,b,F){const L=M.value,A=S+"_"+b;if(F[A]===void 0)return typeof L=="number"||typeof L=="boolean"?F[A]=L:F[A]=L.clone(),!0;{const U=F[A];if(typeof L=="number"||typeof L=="boolean"){if(U!==L)return F[A]=L,!0}else if(U.equals(L)===!1)return U.copy(L),!0}return!1}function g(M){const S=M.uniforms;let b=0;const F=16;for(let A=0,U=S.length;A<U;A++){const E=Array.isArray(S[A])?S[A]:[S[A]];for(let x=0,C=E.length;x<C;x++){const V=E[x],O=Array.isArray(V.value)?V.value:[V.value];for(let q=0,$=O.length;q<$;q++){const X=O[q],Y=_(X),ee=b%F,ae=ee%Y.boundary,ce=ee+ae;b+=ae,ce!==0&&F-ce<Y.storage&&(b+=F-ce),V.__data=new Float32Array(Y.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=b,b+=Y.storage}}}const L=b%F;return L>0&&(b+=F-L),M.__size=b,M.__cache={},this}function _(M){const S={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(S.boundary=4,S.storage=4):M.isVector2?(S.boundary=8,S.storage=8):M.isVector3||M.isColor?(S.boundary=16,S.storage=12):M.isVector4?(S.boundary=16,S.storage=16):M.isMatrix3?(S.boundary=48,S.storage=48):M.isMatrix4?(S.boundary=64,S.storage=64):M.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",M),S}function m(M){const S=M.target;S.removeEventListener("dispose",m);const b=r.indexOf(S.__bindingPointIndex);r.splice(b,1),i.deleteBuffer(s[S.id]),delete s[S.id],delete o[S.id]}function f(){for(const M in s)i.deleteBuffer(s[M]);r=[],s={},o={}}return{bind:l,update:c,dispose:f}}class VI{constructor(e={}){const{canvas:t=P2(),context:n=null,depth:s=!0,stencil:o=!1,alpha:r=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reverseDepthBuffer:d=!1}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=r;const g=new Uint32Array(4),_=new Int32Array(4);let m=null,f=null;const M=[],S=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=zn,this.toneMapping=us,this.toneMappingExposure=1;const b=this;let F=!1,L=0,A=0,U=null,E=-1,x=null;const C=new Wt,V=new Wt;let O=null;const q=new ft(0);let $=0,X=t.width,Y=t.height,ee=1,ae=null,ce=null;const _e=new Wt(0,0,X,Y),be=new Wt(0,0,X,Y);let me=!1;const oe=new Zh;let ue=!1,ve=!1;const he=new Ht,Ie=new Ht,Be=new te,ke=new Wt,ht={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Je=!1;function ut(){return U===null?ee:1}let G=n;function Kt(T,B){return t.getContext(T,B)}try{const T={alpha:!0,depth:s,stencil:o,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${Hh}`),t.addEventListener("webglcontextlost",le,!1),t.addEventListener("webglcontextrestored",Re,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),G===null){const B="webgl2";if(G=Kt(B,T),G===null)throw Kt(B)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(T){throw console.error("THREE.WebGLRenderer: "+T.message),T}let et,nt,We,pt,Ne,I,w,Q,ne,j,ie,Se,ye,Ae,Ze,pe,xe,Oe,He,Ee,ot,Ye,mt,H;function Me(){et=new XN(G),et.init(),Ye=new NI(G,et),nt=new HN(G,et,e,Ye),We=new CI(G,et),nt.reverseDepthBuffer&&d&&We.buffers.depth.setReversed(!0),pt=new KN(G),Ne=new pI,I=new LI(G,et,We,Ne,nt,Ye,pt),w=new GN(b),Q=new qN(b),ne=new iP(G),mt=new zN(G,ne),j=new jN(G,ne,pt,mt),ie=new JN(G,j,ne,pt),He=new ZN(G,nt,I),pe=new VN(Ne),Se=new fI(b,w,Q,et,nt,mt,pe),ye=new BI(b,Ne),Ae=new gI,Ze=new MI(et),Oe=new ON(b,w,Q,We,ie,p,l),xe=new AI(b,ie,nt),H=new HI(G,pt,nt,We),Ee=new BN(G,et,pt),ot=new YN(G,et,pt),pt.programs=Se.programs,b.capabilities=nt,b.extensions=et,b.properties=Ne,b.renderLists=Ae,b.shadowMap=xe,b.state=We,b.info=pt}Me();const se=new OI(b,G);this.xr=se,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){const T=et.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){const T=et.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return ee},this.setPixelRatio=function(T){T!==void 0&&(ee=T,this.setSize(X,Y,!1))},this.getSize=function(T){return T.set(X,Y)},this.setSize=function(T,B,K=!0){if(se.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}X=T,Y=B,t.width=Math.floor(T*ee),t.height=Math.floor(B*ee),K===!0&&(t.style.width=T+"px",t.style.height=B+"px"),this.setViewport(0,0,T,B)},this.getDrawingBufferSize=function(T){return T.set(X*ee,Y*ee).floor()},this.setDrawingBufferSize=function(T,B,K){X=T,Y=B,ee=K,t.width=Math.floor(T*K),t.height=Math.floor(B*K),this.setViewport(0,0,T,B)},this.getCurrentViewport=function(T){return T.copy(C)},this.getViewport=function(T){return T.copy(_e)},this.setViewport=function(T,B,K,Z){T.isVector4?_e.set(T.x,T.y,T.z,T.w):_e.set(T,B,K,Z),We.viewport(C.copy(_e).multiplyScalar(ee).round())},this.getScissor=function(T){return T.copy(be)},this.setScissor=function(T,B,K,Z){T.isVector4?be.set(T.x,T.y,T.z,T.w):be.set(T,B,K,Z),We.scissor(V.copy(be).multiplyScalar(ee).round())},this.getScissorTest=function(){return me},this.setScissorTest=function(T){We.setScissorTest(me=T)},this.setOpaqueSort=function(T){ae=T},this.setTransparentSort=function(T){ce=T},this.getClearColor=function(T){return T.copy(Oe.getClearColor())},this.setClearColor=function(){Oe.setClearColor.apply(Oe,arguments)},this.getClearAlpha=function(){return Oe.getClearAlpha()},this.setClearAlpha=function(){Oe.setClearAlpha.apply(Oe,arguments)},this.clear=function(T=!0,B=!0,K=!0){let Z=0;if(T){let W=!1;if(U!==null){const fe=U.texture.format;W=fe===Xh||fe===qh||fe===$h}if(W){const fe=U.texture.type,we=fe===qi||fe===Xs||fe===Er||fe===Ho||fe===Gh||fe===Wh,ze=Oe.getClearColor(),Ue=Oe.getClearAlpha(),qe=ze.r,je=ze.g,Fe=ze.b;we?(g[0]=qe,g[1]=je,g[2]=Fe,g[3]=Ue,G.clearBufferuiv(G.COLOR,0,g)):(_[0]=qe,_[1]=je,_[2]=Fe,_[3]=Ue,G.clearBufferiv(G.COLOR,0,_))}else Z|=G.COLOR_BUFFER_BIT}B&&(Z|=G.DEPTH_BUFFER_BIT),K&&(Z|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),G.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",le,!1),t.removeEventListener("webglcontextrestored",Re,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),Ae.dispose(),Ze.dispose(),Ne.dispose(),w.dispose(),Q.dispose(),ie.dispose(),mt.dispose(),H.dispose(),Se.dispose(),se.dispose(),se.removeEventListener("sessionstart",Nn),se.removeEventListener("sessionend",Ai),An.stop()};function le(T){T.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),F=!0}function Re(){console.log("THREE.WebGLRenderer: Context Restored."),F=!1;const T=pt.autoReset,B=xe.enabled,K=xe.autoUpdate,Z=xe.needsUpdate,W=xe.type;Me(),pt.autoReset=T,xe.enabled=B,xe.autoUpdate=K,xe.needsUpdate=Z,xe.type=W}function Ce(T){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function Qe(T){const B=T.target;B.removeEventListener("dispose",Qe),Ft(B)}function Ft(T){nn(T),Ne.remove(T)}function nn(T){const B=Ne.get(T).programs;B!==void 0&&(B.forEach(function(K){Se.releaseProgram(K)}),T.isShaderMaterial&&Se.releaseShaderCache(T))}this.renderBufferDirect=function(T,B,K,Z,W,fe){B===null&&(B=ht);const we=W.isMesh&&W.matrixWorld.determinant()<0,ze=sl(T,B,K,Z,W);We.setMaterial(Z,we);let Ue=K.index,qe=1;if(Z.wireframe===!0){if(Ue=j.getWireframeAttribute(K),Ue===void 0)return;qe=2}const je=K.drawRange,Fe=K.attributes.position;let lt=je.start*qe,wt=(je.start+je.count)*qe;fe!==null&&(lt=Math.max(lt,fe.start*qe),wt=Math.min(wt,(fe.start+fe.count)*qe)),Ue!==null?(lt=Math.max(lt,0),wt=Math.min(wt,Ue.count)):Fe!=null&&(lt=Math.max(lt,0),wt=Math.min(wt,Fe.count));const Tt=wt-lt;if(Tt<0||Tt===1/0)return;mt.setup(W,Z,ze,K,Ue);let sn,dt=Ee;if(Ue!==null&&(sn=ne.get(Ue),dt=ot,dt.setIndex(sn)),W.isMesh)Z.wireframe===!0?(We.setLineWidth(Z.wireframeLinewidth*ut()),dt.setMode(G.LINES)):dt.setMode(G.TRIANGLES);else if(W.isLine){let Ve=Z.linewidth;Ve===void 0&&(Ve=1),We.setLineWidth(Ve*ut()),W.isLineSegments?dt.setMode(G.LINES):W.isLineLoop?dt.setMode(G.LINE_LOOP):dt.setMode(G.LINE_STRIP)}else W.isPoints?dt.setMode(G.POINTS):W.isSprite&&dt.setMode(G.TRIANGLES);if(W.isBatchedMesh)if(W._multiDrawInstances!==null)dt.renderMultiDrawInstances(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount,W._multiDrawInstances);else if(et.get("WEBGL_multi_draw"))dt.renderMultiDraw(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount);else{const Ve=W._multiDrawStarts,Ot=W._multiDrawCounts,gt=W._multiDrawCount,Rn=Ue?ne.get(Ue).bytesPerElement:1,di=Ne.get(Z).currentProgram.getUniforms();for(let gn=0;gn<gt;gn++)di.setValue(G,"_gl_DrawID",gn),dt.render(Ve[gn]/Rn,Ot[gn])}else if(W.isInstancedMesh)dt.renderInstances(lt,Tt,W.count);else if(K.isInstancedBufferGeometry){const Ve=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ot=Math.min(K.instanceCount,Ve);dt.renderInstances(lt,Tt,Ot)}else dt.render(lt,Tt)};function xt(T,B,K){T.transparent===!0&&T.side===Oi&&T.forceSinglePass===!1?(T.side=Ln,T.needsUpdate=!0,Js(T,B,K),T.side=ms,T.needsUpdate=!0,Js(T,B,K),T.side=Oi):Js(T,B,K)}this.compile=function(T,B,K=null){K===null&&(K=T),f=Ze.get(K),f.init(B),S.push(f),K.traverseVisible(function(W){W.isLight&&W.layers.test(B.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),T!==K&&T.traverseVisible(function(W){W.isLight&&W.layers.test(B.layers)&&(f.pushLight(W),W.castShadow&&f.pushShadow(W))}),f.setupLights();const Z=new Set;return T.traverse(function(W){if(!(W.isMesh||W.isPoints||W.isLine||W.isSprite))return;const fe=W.material;if(fe)if(Array.isArray(fe))for(let we=0;we<fe.length;we++){const ze=fe[we];xt(ze,K,W),Z.add(ze)}else xt(fe,K,W),Z.add(fe)}),S.pop(),f=null,Z},this.compileAsync=function(T,B,K=null){const Z=this.compile(T,B,K);return new Promise(W=>{function fe(){if(Z.forEach(function(we){Ne.get(we).currentProgram.isReady()&&Z.delete(we)}),Z.size===0){W(T);return}setTimeout(fe,10)}et.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let Zt=null;function Nt(T){Zt&&Zt(T)}function Nn(){An.stop()}function Ai(){An.start()}const An=new Fm;An.setAnimationLoop(Nt),typeof self<"u"&&An.setContext(self),this.setAnimationLoop=function(T){Zt=T,se.setAnimationLoop(T),T===null?An.stop():An.start()},se.addEventListener("sessionstart",Nn),se.addEventListener("sessionend",Ai),this.render=function(T,B){if(B!==void 0&&B.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(F===!0)return;if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),se.enabled===!0&&se.isPresenting===!0&&(se.cameraAutoUpdate===!0&&se.updateCamera(B),B=se.getCamera()),T.isScene===!0&&T.onBeforeRender(b,T,B,U),f=Ze.get(T,S.length),f.init(B),S.push(f),Ie.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),oe.setFromProjectionMatrix(Ie),ve=this.localClippingEnabled,ue=pe.init(this.clippingPlanes,ve),m=Ae.get(T,M.length),m.init(),M.push(m),se.enabled===!0&&se.isPresenting===!0){const fe=b.xr.getDepthSensingMesh();fe!==null&&mn(fe,B,-1/0,b.sortObjects)}mn(T,B,0,b.sortObjects),m.finish(),b.sortObjects===!0&&m.sort(ae,ce),Je=se.enabled===!1||se.isPresenting===!1||se.hasDepthSensing()===!1,Je&&Oe.addToRenderList(m,T),this.info.render.frame++,ue===!0&&pe.beginShadows();const K=f.state.shadowsArray;xe.render(K,T,B),ue===!0&&pe.endShadows(),this.info.autoReset===!0&&this.info.reset();const Z=m.opaque,W=m.transmissive;if(f.setupLights(),B.isArrayCamera){const fe=B.cameras;if(W.length>0)for(let we=0,ze=fe.length;we<ze;we++){const Ue=fe[we];Ci(Z,W,T,Ue)}Je&&Oe.render(T);for(let we=0,ze=fe.length;we<ze;we++){const Ue=fe[we];Ri(m,T,Ue,Ue.viewport)}}else W.length>0&&Ci(Z,W,T,B),Je&&Oe.render(T),Ri(m,T,B);U!==null&&(I.updateMultisampleRenderTarget(U),I.updateRenderTargetMipmap(U)),T.isScene===!0&&T.onAfterRender(b,T,B),mt.resetDefaultState(),E=-1,x=null,S.pop(),S.length>0?(f=S[S.length-1],ue===!0&&pe.setGlobalState(b.clippingPlanes,f.state.camera)):f=null,M.pop(),M.length>0?m=M[M.length-1]:m=null};function mn(T,B,K,Z){if(T.visible===!1)return;if(T.layers.test(B.layers)){if(T.isGroup)K=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(B);else if(T.isLight)f.pushLight(T),T.castShadow&&f.pushShadow(T);else if(T.isSprite){if(!T.frustumCulled||oe.intersectsSprite(T)){Z&&ke.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ie);const we=ie.update(T),ze=T.material;ze.visible&&m.push(T,we,ze,K,ke.z,null)}}else if((T.isMesh||T.isLine||T.isPoints)&&(!T.frustumCulled||oe.intersectsObject(T))){const we=ie.update(T),ze=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ke.copy(T.boundingSphere.center)):(we.boundingSphere===null&&we.computeBoundingSphere(),ke.copy(we.boundingSphere.center)),ke.applyMatrix4(T.matrixWorld).applyMatrix4(Ie)),Array.isArray(ze)){const Ue=we.groups;for(let qe=0,je=Ue.length;qe<je;qe++){const Fe=Ue[qe],lt=ze[Fe.materialIndex];lt&&lt.visible&&m.push(T,we,lt,K,ke.z,Fe)}}else ze.visible&&m.push(T,we,ze,K,ke.z,null)}}const fe=T.children;for(let we=0,ze=fe.length;we<ze;we++)mn(fe[we],B,K,Z)}function Ri(T,B,K,Z){const W=T.opaque,fe=T.transmissive,we=T.transparent;f.setupLightsView(K),ue===!0&&pe.setGlobalState(b.clippingPlanes,K),Z&&We.viewport(C.copy(Z)),W.length>0&&vs(W,B,K),fe.length>0&&vs(fe,B,K),we.length>0&&vs(we,B,K),We.buffers.depth.setTest(!0),We.buffers.depth.setMask(!0),We.buffers.color.setMask(!0),We.setPolygonOffset(!1)}function Ci(T,B,K,Z){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;f.state.transmissionRenderTarget[Z.id]===void 0&&(f.state.transmissionRenderTarget[Z.id]=new js(1,1,{generateMipmaps:!0,type:et.has("EXT_color_buffer_half_float")||et.has("EXT_color_buffer_float")?Cr:qi,minFilter:zs,samples:4,stencilBuffer:o,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:_t.workingColorSpace}));const fe=f.state.transmissionRenderTarget[Z.id],we=Z.viewport||C;fe.setSize(we.z,we.w);const ze=b.getRenderTarget();b.setRenderTarget(fe),b.getClearColor(q),$=b.getClearAlpha(),$<1&&b.setClearColor(16777215,.5),b.clear(),Je&&Oe.render(K);const Ue=b.toneMapping;b.toneMapping=us;const qe=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),f.setupLightsView(Z),ue===!0&&pe.setGlobalState(b.clippingPlanes,Z),vs(T,K,Z),I.updateMultisampleRenderTarget(fe),I.updateRenderTargetMipmap(fe),et.has("WEBGL_multisampled_render_to_texture")===!1){let je=!1;for(let Fe=0,lt=B.length;Fe<lt;Fe++){const wt=B[Fe],Tt=wt.object,sn=wt.geometry,dt=wt.material,Ve=wt.group;if(dt.side===Oi&&Tt.layers.test(Z.layers)){const Ot=dt.side;dt.side=Ln,dt.needsUpdate=!0,Qo(Tt,K,Z,sn,dt,Ve),dt.side=Ot,dt.needsUpdate=!0,je=!0}}je===!0&&(I.updateMultisampleRenderTarget(fe),I.updateRenderTargetMipmap(fe))}b.setRenderTarget(ze),b.setClearColor(q,$),qe!==void 0&&(Z.viewport=qe),b.toneMapping=Ue}function vs(T,B,K){const Z=B.isScene===!0?B.overrideMaterial:null;for(let W=0,fe=T.length;W<fe;W++){const we=T[W],ze=we.object,Ue=we.geometry,qe=Z===null?we.material:Z,je=we.group;ze.layers.test(K.layers)&&Qo(ze,B,K,Ue,qe,je)}}function Qo(T,B,K,Z,W,fe){T.onBeforeRender(b,B,K,Z,W,fe),T.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),W.onBeforeRender(b,B,K,Z,T,fe),W.transparent===!0&&W.side===Oi&&W.forceSinglePass===!1?(W.side=Ln,W.needsUpdate=!0,b.renderBufferDirect(K,B,Z,W,T,fe),W.side=ms,W.needsUpdate=!0,b.renderBufferDirect(K,B,Z,W,T,fe),W.side=Oi):b.renderBufferDirect(K,B,Z,W,T,fe),T.onAfterRender(b,B,K,Z,W,fe)}function Js(T,B,K){B.isScene!==!0&&(B=ht);const Z=Ne.get(T),W=f.state.lights,fe=f.state.shadowsArray,we=W.state.version,ze=Se.getParameters(T,W.state,fe,B,K),Ue=Se.getProgramCacheKey(ze);let qe=Z.programs;Z.environment=T.isMeshStandardMaterial?B.environment:null,Z.fog=B.fog,Z.envMap=(T.isMeshStandardMaterial?Q:w).get(T.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&T.envMap===null?B.environmentRotation:T.envMapRotation,qe===void 0&&(T.addEventListener("dispose",Qe),qe=new Map,Z.programs=qe);let je=qe.get(Ue);if(je!==void 0){if(Z.currentProgram===je&&Z.lightsStateVersion===we)return ui(T,ze),je}else ze.uniforms=Se.getUniforms(T),T.onBeforeCompile(ze,b),je=Se.acquireProgram(ze,Ue),qe.set(Ue,je),Z.uniforms=ze.uniforms;const Fe=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Fe.clippingPlanes=pe.uniform),ui(T,ze),Z.needsLights=Ur(T),Z.lightsStateVersion=we,Z.needsLights&&(Fe.ambientLightColor.value=W.state.ambient,Fe.lightProbe.value=W.state.probe,Fe.directionalLights.value=W.state.directional,Fe.directionalLightShadows.value=W.state.directionalShadow,Fe.spotLights.value=W.state.spot,Fe.spotLightShadows.value=W.state.spotShadow,Fe.rectAreaLights.value=W.state.rectArea,Fe.ltc_1.value=W.state.rectAreaLTC1,Fe.ltc_2.value=W.state.rectAreaLTC2,Fe.pointLights.value=W.state.point,Fe.pointLightShadows.value=W.state.pointShadow,Fe.hemisphereLights.value=W.state.hemi,Fe.directionalShadowMap.value=W.state.directionalShadowMap,Fe.directionalShadowMatrix.value=W.state.directionalShadowMatrix,Fe.spotShadowMap.value=W.state.spotShadowMap,Fe.spotLightMatrix.value=W.state.spotLightMatrix,Fe.spotLightMap.value=W.state.spotLightMap,Fe.pointShadowMap.value=W.state.pointShadowMap,Fe.pointShadowMatrix.value=W.state.pointShadowMatrix),Z.currentProgram=je,Z.uniformsList=null,je}function kr(T){if(T.uniformsList===null){const B=T.currentProgram.getUniforms();T.uniformsList=Ra.seqWithValue(B.seq,T.uniforms)}return T.uniformsList}function ui(T,B){const K=Ne.get(T);K.outputColorSpace=B.outputColorSpace,K.batching=B.batching,K.batchingColor=B.batchingColor,K.instancing=B.instancing,K.instancingColor=B.instancingColor,K.instancingMorph=B.instancingMorph,K.skinning=B.skinning,K.morphTargets=B.morphTargets,K.morphNormals=B.morphNormals,K.morphColors=B.morphColors,K.morphTargetsCount=B.morphTargetsCount,K.numClippingPlanes=B.numClippingPlanes,K.numIntersection=B.numClipIntersection,K.vertexAlphas=B.vertexAlphas,K.vertexTangents=B.vertexTangents,K.toneMapping=B.toneMapping}function sl(T,B,K,Z,W){B.isScene!==!0&&(B=ht),I.resetTextureUnits();const fe=B.fog,we=Z.isMeshStandardMaterial?B.environment:null,ze=U===null?b.outputColorSpace:U.isXRRenderTarget===!0?U.texture.colorSpace:Yo,Ue=(Z.isMeshStandardMaterial?Q:w).get(Z.envMap||we),qe=Z.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,je=!!K.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Fe=!!K.morphAttributes.position,lt=!!K.morphAttributes.normal,wt=!!K.morphAttributes.color;let Tt=us;Z.toneMapped&&(U===null||U.isXRRenderTarget===!0)&&(Tt=b.toneMapping);const sn=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,dt=sn!==void 0?sn.length:0,Ve=Ne.get(Z),Ot=f.state.lights;if(ue===!0&&(ve===!0||T!==x)){const yn=T===x&&Z.id===E;pe.setState(Z,T,yn)}let gt=!1;Z.version===Ve.__version?(Ve.needsLights&&Ve.lightsStateVersion!==Ot.state.version||Ve.outputColorSpace!==ze||W.isBatchedMesh&&Ve.batching===!1||!W.isBatchedMesh&&Ve.batching===!0||W.isBatchedMesh&&Ve.batchingColor===!0&&W.colorTexture===null||W.isBatchedMesh&&Ve.batchingColor===!1&&W.colorTexture!==null||W.isInstancedMesh&&Ve.instancing===!1||!W.isInstancedMesh&&Ve.instancing===!0||W.isSkinnedMesh&&Ve.skinning===!1||!W.isSkinnedMesh&&Ve.skinning===!0||W.isInstancedMesh&&Ve.instancingColor===!0&&W.instanceColor===null||W.isInstancedMesh&&Ve.instancingColor===!1&&W.instanceColor!==null||W.isInstancedMesh&&Ve.instancingMorph===!0&&W.morphTexture===null||W.isInstancedMesh&&Ve.instancingMorph===!1&&W.morphTexture!==null||Ve.envMap!==Ue||Z.fog===!0&&Ve.fog!==fe||Ve.numClippingPlanes!==void 0&&(Ve.numClippingPlanes!==pe.numPlanes||Ve.numIntersection!==pe.numIntersection)||Ve.vertexAlphas!==qe||Ve.vertexTangents!==je||Ve.morphTargets!==Fe||Ve.morphNormals!==lt||Ve.morphColors!==wt||Ve.toneMapping!==Tt||Ve.morphTargetsCount!==dt)&&(gt=!0):(gt=!0,Ve.__version=Z.version);let Rn=Ve.currentProgram;gt===!0&&(Rn=Js(Z,B,W));let di=!1,gn=!1,ys=!1;const Ct=Rn.getUniforms(),Vn=Ve.uniforms;if(We.useProgram(Rn.program)&&(di=!0,gn=!0,ys=!0),Z.id!==E&&(E=Z.id,gn=!0),di||x!==T){We.buffers.depth.getReversed()?(he.copy(T.projectionMatrix),N2(he),D2(he),Ct.setValue(G,"projectionMatrix",he)):Ct.setValue(G,"projectionMatrix",T.projectionMatrix),Ct.setValue(G,"viewMatrix",T.matrixWorldInverse);const fi=Ct.map.cameraPosition;fi!==void 0&&fi.setValue(G,Be.setFromMatrixPosition(T.matrixWorld)),nt.logarithmicDepthBuffer&&Ct.setValue(G,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Ct.setValue(G,"isOrthographic",T.isOrthographicCamera===!0),x!==T&&(x=T,gn=!0,ys=!0)}if(W.isSkinnedMesh){Ct.setOptional(G,W,"bindMatrix"),Ct.setOptional(G,W,"bindMatrixInverse");const yn=W.skeleton;yn&&(yn.boneTexture===null&&yn.computeBoneTexture(),Ct.setValue(G,"boneTexture",yn.boneTexture,I))}W.isBatchedMesh&&(Ct.setOptional(G,W,"batchingTexture"),Ct.setValue(G,"batchingTexture",W._matricesTexture,I),Ct.setOptional(G,W,"batchingIdTexture"),Ct.setValue(G,"batchingIdTexture",W._indirectTexture,I),Ct.setOptional(G,W,"batchingColorTexture"),W._colorsTexture!==null&&Ct.setValue(G,"batchingColorTexture",W._colorsTexture,I));const Xi=K.morphAttributes;if((Xi.position!==void 0||Xi.normal!==void 0||Xi.color!==void 0)&&He.update(W,K,Rn),(gn||Ve.receiveShadow!==W.receiveShadow)&&(Ve.receiveShadow=W.receiveShadow,Ct.setValue(G,"receiveShadow",W.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Vn.envMap.value=Ue,Vn.flipEnvMap.value=Ue.isCubeTexture&&Ue.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&B.environment!==null&&(Vn.envMapIntensity.value=B.environmentIntensity),gn&&(Ct.setValue(G,"toneMappingExposure",b.toneMappingExposure),Ve.needsLights&&bs(Vn,ys),fe&&Z.fog===!0&&ye.refreshFogUniforms(Vn,fe),ye.refreshMaterialUniforms(Vn,Z,ee,Y,f.state.transmissionRenderTarget[T.id]),Ra.upload(G,kr(Ve),Vn,I)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ra.upload(G,kr(Ve),Vn,I),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Ct.setValue(G,"center",W.center),Ct.setValue(G,"modelViewMatrix",W.modelViewMatrix),Ct.setValue(G,"normalMatrix",W.normalMatrix),Ct.setValue(G,"modelMatrix",W.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){const yn=Z.uniformsGroups;for(let fi=0,Jn=yn.length;fi<Jn;fi++){const Qs=yn[fi];H.update(Qs,Rn),H.bind(Qs,Rn)}}return Rn}function bs(T,B){T.ambientLightColor.needsUpdate=B,T.lightProbe.needsUpdate=B,T.directionalLights.needsUpdate=B,T.directionalLightShadows.needsUpdate=B,T.pointLights.needsUpdate=B,T.pointLightShadows.needsUpdate=B,T.spotLights.needsUpdate=B,T.spotLightShadows.needsUpdate=B,T.rectAreaLights.needsUpdate=B,T.hemisphereLights.needsUpdate=B}function Ur(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return A},this.getRenderTarget=function(){return U},this.setRenderTargetTextures=function(T,B,K){Ne.get(T.texture).__webglTexture=B,Ne.get(T.depthTexture).__webglTexture=K;const Z=Ne.get(T);Z.__hasExternalTextures=!0,Z.__autoAllocateDepthBuffer=K===void 0,Z.__autoAllocateDepthBuffer||et.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),Z.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(T,B){const K=Ne.get(T);K.__webglFramebuffer=B,K.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(T,B=0,K=0){U=T,L=B,A=K;let Z=!0,W=null,fe=!1,we=!1;if(T){const Ue=Ne.get(T);if(Ue.__useDefaultFramebuffer!==void 0)We.bindFramebuffer(G.FRAMEBUFFER,null),Z=!1;else if(Ue.__webglFramebuffer===void 0)I.setupRenderTarget(T);else if(Ue.__hasExternalTextures)I.rebindTextures(T,Ne.get(T.texture).__webglTexture,Ne.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){const Fe=T.depthTexture;if(Ue.__boundDepthTexture!==Fe){if(Fe!==null&&Ne.has(Fe)&&(T.width!==Fe.image.width||T.height!==Fe.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");I.setupDepthRenderbuffer(T)}}const qe=T.texture;(qe.isData3DTexture||qe.isDataArrayTexture||qe.isCompressedArrayTexture)&&(we=!0);const je=Ne.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(je[B])?W=je[B][K]:W=je[B],fe=!0):T.samples>0&&I.useMultisampledRTT(T)===!1?W=Ne.get(T).__webglMultisampledFramebuffer:Array.isArray(je)?W=je[K]:W=je,C.copy(T.viewport),V.copy(T.scissor),O=T.scissorTest}else C.copy(_e).multiplyScalar(ee).floor(),V.copy(be).multiplyScalar(ee).floor(),O=me;if(We.bindFramebuffer(G.FRAMEBUFFER,W)&&Z&&We.drawBuffers(T,W),We.viewport(C),We.scissor(V),We.setScissorTest(O),fe){const Ue=Ne.get(T.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ue.__webglTexture,K)}else if(we){const Ue=Ne.get(T.texture),qe=B||0;G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,Ue.__webglTexture,K||0,qe)}E=-1},this.readRenderTargetPixels=function(T,B,K,Z,W,fe,we){if(!(T&&T.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let ze=Ne.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&we!==void 0&&(ze=ze[we]),ze){We.bindFramebuffer(G.FRAMEBUFFER,ze);try{const Ue=T.texture,qe=Ue.format,je=Ue.type;if(!nt.textureFormatReadable(qe)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!nt.textureTypeReadable(je)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=T.width-Z&&K>=0&&K<=T.height-W&&G.readPixels(B,K,Z,W,Ye.convert(qe),Ye.convert(je),fe)}finally{const Ue=U!==null?Ne.get(U).__webglFramebuffer:null;We.bindFramebuffer(G.FRAMEBUFFER,Ue)}}},this.readRenderTargetPixelsAsync=async function(T,B,K,Z,W,fe,we){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let ze=Ne.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&we!==void 0&&(ze=ze[we]),ze){const Ue=T.texture,qe=Ue.format,je=Ue.type;if(!nt.textureFormatReadable(qe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!nt.textureTypeReadable(je))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(B>=0&&B<=T.width-Z&&K>=0&&K<=T.height-W){We.bindFramebuffer(G.FRAMEBUFFER,ze);const Fe=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Fe),G.bufferData(G.PIXEL_PACK_BUFFER,fe.byteLength,G.STREAM_READ),G.readPixels(B,K,Z,W,Ye.convert(qe),Ye.convert(je),0);const lt=U!==null?Ne.get(U).__webglFramebuffer:null;We.bindFramebuffer(G.FRAMEBUFFER,lt);const wt=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await L2(G,wt,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Fe),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,fe),G.deleteBuffer(Fe),G.deleteSync(wt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(T,B=null,K=0){T.isTexture!==!0&&(_r("WebGLRenderer: copyFramebufferToTexture function signature has changed."),B=arguments[0]||null,T=arguments[1]);const Z=Math.pow(2,-K),W=Math.floor(T.image.width*Z),fe=Math.floor(T.image.height*Z),we=B!==null?B.x:0,ze=B!==null?B.y:0;I.setTexture2D(T,0),G.copyTexSubImage2D(G.TEXTURE_2D,K,0,0,we,ze,W,fe),We.unbindTexture()},this.copyTextureToTexture=function(T,B,K=null,Z=null,W=0){T.isTexture!==!0&&(_r("WebGLRenderer: copyTextureToTexture function signature has changed."),Z=arguments[0]||null,T=arguments[1],B=arguments[2],W=arguments[3]||0,K=null);let fe,we,ze,Ue,qe,je,Fe,lt,wt;const Tt=T.isCompressedTexture?T.mipmaps[W]:T.image;K!==null?(fe=K.max.x-K.min.x,we=K.max.y-K.min.y,ze=K.isBox3?K.max.z-K.min.z:1,Ue=K.min.x,qe=K.min.y,je=K.isBox3?K.min.z:0):(fe=Tt.width,we=Tt.height,ze=Tt.depth||1,Ue=0,qe=0,je=0),Z!==null?(Fe=Z.x,lt=Z.y,wt=Z.z):(Fe=0,lt=0,wt=0);const sn=Ye.convert(B.format),dt=Ye.convert(B.type);let Ve;B.isData3DTexture?(I.setTexture3D(B,0),Ve=G.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(I.setTexture2DArray(B,0),Ve=G.TEXTURE_2D_ARRAY):(I.setTexture2D(B,0),Ve=G.TEXTURE_2D),G.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,B.flipY),G.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),G.pixelStorei(G.UNPACK_ALIGNMENT,B.unpackAlignment);const Ot=G.getParameter(G.UNPACK_ROW_LENGTH),gt=G.getParameter(G.UNPACK_IMAGE_HEIGHT),Rn=G.getParameter(G.UNPACK_SKIP_PIXELS),di=G.getParameter(G.UNPACK_SKIP_ROWS),gn=G.getParameter(G.UNPACK_SKIP_IMAGES);G.pixelStorei(G.UNPACK_ROW_LENGTH,Tt.width),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Tt.height),G.pixelStorei(G.UNPACK_SKIP_PIXELS,Ue),G.pixelStorei(G.UNPACK_SKIP_ROWS,qe),G.pixelStorei(G.UNPACK_SKIP_IMAGES,je);const ys=T.isDataArrayTexture||T.isData3DTexture,Ct=B.isDataArrayTexture||B.isData3DTexture;if(T.isRenderTargetTexture||T.isDepthTexture){const Vn=Ne.get(T),Xi=Ne.get(B),yn=Ne.get(Vn.__renderTarget),fi=Ne.get(Xi.__renderTarget);We.bindFramebuffer(G.READ_FRAMEBUFFER,yn.__webglFramebuffer),We.bindFramebuffer(G.DRAW_FRAMEBUFFER,fi.__webglFramebuffer);for(let Jn=0;Jn<ze;Jn++)ys&&G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Ne.get(T).__webglTexture,W,je+Jn),T.isDepthTexture?(Ct&&G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,Ne.get(B).__webglTexture,W,wt+Jn),G.blitFramebuffer(Ue,qe,fe,we,Fe,lt,fe,we,G.DEPTH_BUFFER_BIT,G.NEAREST)):Ct?G.copyTexSubImage3D(Ve,W,Fe,lt,wt+Jn,Ue,qe,fe,we):G.copyTexSubImage2D(Ve,W,Fe,lt,wt+Jn,Ue,qe,fe,we);We.bindFramebuffer(G.READ_FRAMEBUFFER,null),We.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else Ct?T.isDataTexture||T.isData3DTexture?G.texSubImage3D(Ve,W,Fe,lt,wt,fe,we,ze,sn,dt,Tt.data):B.isCompressedArrayTexture?G.compressedTexSubImage3D(Ve,W,Fe,lt,wt,fe,we,ze,sn,Tt.data):G.texSubImage3D(Ve,W,Fe,lt,wt,fe,we,ze,sn,dt,Tt):T.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,W,Fe,lt,fe,we,sn,dt,Tt.data):T.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,W,Fe,lt,Tt.width,Tt.height,sn,Tt.data):G.texSubImage2D(G.TEXTURE_2D,W,Fe,lt,fe,we,sn,dt,Tt);G.pixelStorei(G.UNPACK_ROW_LENGTH,Ot),G.pixelStorei(G.UNPACK_IMAGE_HEIGHT,gt),G.pixelStorei(G.UNPACK_SKIP_PIXELS,Rn),G.pixelStorei(G.UNPACK_SKIP_ROWS,di),G.pixelStorei(G.UNPACK_SKIP_IMAGES,gn),W===0&&B.generateMipmaps&&G.generateMipmap(Ve),We.unbindTexture()},this.copyTextureToTexture3D=function(T,B,K=null,Z=null,W=0){return T.isTexture!==!0&&(_r("WebGLRenderer: copyTextureToTexture3D function signature has changed."),K=arguments[0]||null,Z=arguments[1]||null,T=arguments[2],B=arguments[3],W=arguments[4]||0),_r('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(T,B,K,Z,W)},this.initRenderTarget=function(T){Ne.get(T).__webglFramebuffer===void 0&&I.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?I.setTextureCube(T,0):T.isData3DTexture?I.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?I.setTexture2DArray(T,0):I.setTexture2D(T,0),We.unbindTexture()},this.resetState=function(){L=0,A=0,U=null,We.reset(),mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorspace=_t._getDrawingBufferColorSpace(e),t.unpackColorSpace=_t._getUnpackColorSpace()}}class Qh{constructor(e,t=1,n=1e3){this.isFog=!0,this.name="",this.color=new ft(e),this.near=t,this.far=n}clone(){return new Qh(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}}class GI extends pn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ti,this.environmentIntensity=1,this.environmentRotation=new Ti,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}}class WI extends Tn{constructor(e,t,n,s,o,r,a,l,c){super(e,t,n,s,o,r,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class Wo extends _s{constructor(e=1,t=1,n=1,s=32,o=1,r=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:o,openEnded:r,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),o=Math.floor(o);const h=[],u=[],d=[],p=[];let g=0;const _=[],m=n/2;let f=0;M(),r===!1&&(e>0&&S(!0),t>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new wi(u,3)),this.setAttribute("normal",new wi(d,3)),this.setAttribute("uv",new wi(p,2));function M(){const b=new te,F=new te;let L=0;const A=(t-e)/n;for(let U=0;U<=o;U++){const E=[],x=U/o,C=x*(t-e)+e;for(let V=0;V<=s;V++){const O=V/s,q=O*l+a,$=Math.sin(q),X=Math.cos(q);F.x=C*$,F.y=-x*n+m,F.z=C*X,u.push(F.x,F.y,F.z),b.set($,A,X).normalize(),d.push(b.x,b.y,b.z),p.push(O,1-x),E.push(g++)}_.push(E)}for(let U=0;U<s;U++)for(let E=0;E<o;E++){const x=_[E][U],C=_[E+1][U],V=_[E+1][U+1],O=_[E][U+1];(e>0||E!==0)&&(h.push(x,C,O),L+=3),(t>0||E!==o-1)&&(h.push(C,V,O),L+=3)}c.addGroup(f,L,0),f+=L}function S(b){const F=g,L=new vt,A=new te;let U=0;const E=b===!0?e:t,x=b===!0?1:-1;for(let V=1;V<=s;V++)u.push(0,m*x,0),d.push(0,x,0),p.push(.5,.5),g++;const C=g;for(let V=0;V<=s;V++){const q=V/s*l+a,$=Math.cos(q),X=Math.sin(q);A.x=E*X,A.y=m*x,A.z=E*$,u.push(A.x,A.y,A.z),d.push(0,x,0),L.x=$*.5+.5,L.y=X*.5*x+.5,p.push(L.x,L.y),g++}for(let V=0;V<s;V++){const O=F+V,q=C+V;b===!0?h.push(q,q+1,O):h.push(q+1,q,O),U+=3}c.addGroup(f,U,b===!0?1:2),f+=U}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Wo(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}}class Wm extends Dr{static get type(){return"MeshStandardMaterial"}constructor(e){super(),this.isMeshStandardMaterial=!0,this.defines={STANDARD:""},this.color=new ft(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ft(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Em,this.normalScale=new vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ti,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}}class eu extends pn{constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ft(e),this.intensity=t}dispose(){}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){const t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,this.groundColor!==void 0&&(t.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(t.object.distance=this.distance),this.angle!==void 0&&(t.object.angle=this.angle),this.decay!==void 0&&(t.object.decay=this.decay),this.penumbra!==void 0&&(t.object.penumbra=this.penumbra),this.shadow!==void 0&&(t.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(t.object.target=this.target.uuid),t}}class $I extends eu{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ft(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}}const oc=new Ht,Bf=new te,Hf=new te;class qI{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new vt(512,512),this.map=null,this.mapPass=null,this.matrix=new Ht,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zh,this._frameExtents=new vt(1,1),this._viewportCount=1,this._viewports=[new Wt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(e){const t=this.camera,n=this.matrix;Bf.setFromMatrixPosition(e.matrixWorld),t.position.copy(Bf),Hf.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Hf),t.updateMatrixWorld(),oc.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),this._frustum.setFromProjectionMatrix(oc),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(oc)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.mapSize.copy(e.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const e={};return this.intensity!==1&&(e.intensity=this.intensity),this.bias!==0&&(e.bias=this.bias),this.normalBias!==0&&(e.normalBias=this.normalBias),this.radius!==1&&(e.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(e.mapSize=this.mapSize.toArray()),e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}}class XI extends qI{constructor(){super(new Om(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class jI extends eu{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(pn.DEFAULT_UP),this.updateMatrix(),this.target=new pn,this.shadow=new XI}dispose(){this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}}class YI extends eu{constructor(e,t){super(e,t),this.isAmbientLight=!0,this.type="AmbientLight"}}const Vf=new Ht;class KI{constructor(e,t,n=0,s=1/0){this.ray=new Pm(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Yh,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):console.error("THREE.Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Vf.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Vf),this}intersectObject(e,t=!0,n=[]){return uh(e,this,n,t),n.sort(Gf),n}intersectObjects(e,t=!0,n=[]){for(let s=0,o=e.length;s<o;s++)uh(e[s],this,n,t);return n.sort(Gf),n}}function Gf(i,e){return i.distance-e.distance}function uh(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){const o=i.children;for(let r=0,a=o.length;r<a;r++)uh(o[r],e,t,!0)}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Hh}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Hh);function ZI(i,e){return-i*e*1.55}const JI=.3,Wf=.8;function $m(i){return i.body_height+2*i.wheel_radius}function qm(i,e){const t=i/$m(e)*JI*e.weight;return Math.max(-Wf*e.weight,Math.min(Wf*e.weight,t))}const QI=120,Eo=.1,Wa=60,$f=1920;class e3{constructor(e,t,n){this.look=e,this.own=t;const s=(o,r=.7,a=0)=>{const l=new Wm({color:o,roughness:r,metalness:a});return n&&(l.color.set(t),l.transparent=!0,l.opacity=.3),l};this.build(s,!n),this.root.add(this.body,...this.wheels),this.body.position.y=e.wheel_radius,this.root.traverse(o=>{o instanceof dn&&(o.castShadow=o.receiveShadow=!n)})}root=new Mi;body=new Mi;wheels=[new Mi,new Mi];x=0;z=0;last=null;build(e,t){const{wheel_radius:n,track:s,body_height:o,body_depth:r}=this.look,a=Math.max(s*.62,.02),l=n*.25,c=(u,d,p,g,_,m,f)=>{const M=new dn(new Ys(p,d,u),g);M.position.set(_,m,f),this.body.add(M)},h=e(this.own,.55);if(c(a,o*.94,r,h,0,l+o*.5,0),t&&c(s*.8,n*.5,r*.55,e("#3b424a",.6),0,0,0),t&&this.look.command_unit!=="V")for(const u of[.22,.5,.78])c(a*1.01,o*.03,r*1.02,e("#20262c",.6),0,l+o*u,0);else if(t){c(a*.72,o*.26,r*.04,e("#20262c",.25),r*.5,l+o*.72,0),c(a*.62,o*.18,r*.05,e("#b9d8c4",.3),r*.505,l+o*.73,0),c(a*.16,o*.08,r*.08,e("#f4f5f6",.5),r*.5,l+o*.42,0);for(const u of[-1,1])c(a*.14,o*.06,r*.07,e("#8b949d",.5),r*.5,l+o*.42,u*a*.22)}if(this.look.payload>0&&t){const u=Math.cbrt(this.look.payload/2500),d=this.look.payload_height-u/2-l;d>0&&c(.008,d,.008,e("#5c656e",.6),0,l+d/2,0),c(u,u,u,e("#8c5a2b",.8),0,this.look.payload_height,0)}this.wheels.forEach((u,d)=>this.tyre(u,d===0?-s/2:s/2,e,t))}tyre(e,t,n,s){const o=this.look.wheel_radius,r=Math.min(this.look.track*.16,o*.7),a=new dn(new Wo(o,o,r,40),n("#23272c",.95)),l=new dn(new Wo(o*.66,o*.66,r*1.04,32),n("#c9ced3",.45,.1));a.rotation.x=l.rotation.x=Math.PI/2,e.add(a),s&&e.add(l);for(let c=0;s&&c<3;c+=1){const h=new dn(new Ys(o*1.2,o*.13,r*1.1),n("#5c656e",.6));h.rotation.z=c*Math.PI/3,e.add(h)}e.position.set(0,o,t)}move(e,t){const{wheel_radius:n,track:s}=this.look,[o,,r,,a]=e;if(this.last!==null){const c=n*(r-this.last);this.x+=c*Math.cos(a),this.z-=c*Math.sin(a)}this.last=r,this.root.rotation.y=a,this.root.position.set(this.x+t*Math.sin(a),0,this.z+t*Math.cos(a)),this.body.rotation.z=-o;const l=s/(2*n)*a;this.wheels[0].rotation.z=-(r-l),this.wheels[1].rotation.z=-(r+l)}shift(e,t){this.x+=e,this.z+=t}start(e){e&&([this.x,this.z,this.last]=[e.x,e.z,e.last])}}function t3(i){const e=document.createElement("canvas");e.width=e.height=128;const t=e.getContext("2d");t.fillStyle=i?"#252b32":"#eeeeec",t.fillRect(0,0,128,128),t.strokeStyle=i?"#39424b":"#cfd1d2",t.lineWidth=2,t.strokeRect(0,0,128,128);const n=new WI(e);return n.wrapS=n.wrapT=Ha,n.repeat.set(Wa,Wa),n.anisotropy=8,n.colorSpace=zn,n}class n3{constructor(e,t){this.canvas=e,this.push=t,this.element=e,this.renderer=new VI({canvas:e,antialias:!0}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=dm,this.floor=new dn(new Ir(Wa*Eo,Wa*Eo),new Wm({roughness:.95})),this.floor.rotation.x=-Math.PI/2,this.floor.receiveShadow=!0,this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=6,this.sun.shadow.bias=-5e-4,this.shaft=new dn(new Wo(1,1,1,16),this.ink),this.head=new dn(new Wo(0,1,1,24),this.ink),this.arrow.add(this.shaft,this.head),this.arrow.visible=!1,this.ground.add(this.floor,this.arrow),this.scene.add(this.ground,this.sky,this.sun,this.sun.target,new YI("#ffffff",.35)),this.paint(),this.listen()}renderer;scene=new GI;camera=new Kn(32,1,.02,30);sun=new jI("#fffdf8",2.4);sky=new $I("#ffffff","#c4c6c8",1.1);floor;ground=new Mi;figures=[];bodies=[];look=null;arrow=new Mi;shaft;head;ink=new Kh;eye={azimuth:.5,height:.26,away:1};grip=null;turning=null;centre=new te;calm=matchMedia("(prefers-reduced-motion: reduce)");slow=0;detail=1;seen=-1;stale=!0;element;paint(){const e=document.documentElement.dataset.theme==="dark";this.ink.color.set(ps().push);const t=new ft(e?"#1b2026":"#f4f3ef");this.scene.background=t,this.scene.fog=new Qh(t,1.2*this.size()+1.2,3*this.size()+2.2),this.floor.material.map=t3(e),this.floor.material.needsUpdate=!0,this.sun.intensity=e?1.7:1.9,this.stale=!0,this.sky.intensity=e?.7:1;const[n,s]=[this.look,this.bodies];n&&this.furnish(n,s)}furnish(e,t){const n=new Map(this.bodies.map((a,l)=>[a,this.figures[l]]));for(const a of this.figures)this.ground.remove(a.root);const s=this.look===null;this.look=e,this.bodies=t,this.seen=-1,this.stale=!0,this.figures=t.map((a,l)=>new e3(e,cs(a),l>0)),this.figures.forEach((a,l)=>a.start(n.get(t[l])));for(const a of this.figures)this.ground.add(a.root);const o=this.size(),r=o*2.2;Object.assign(this.sun.shadow.camera,{left:-r,right:r,top:r,bottom:-r,near:.01,far:o*12}),this.sun.shadow.camera.updateProjectionMatrix(),s&&this.paint()}size(){return this.look?Math.max($m(this.look),this.look.payload>0?1.1*(this.look.payload_height+this.look.wheel_radius):0):.25}move(e){if(!this.look||e.x.length!==this.figures.length||e.n===this.seen)return;this.seen=e.n,this.stale=!0;const t=this.look.track;this.ground.rotation.z=e.f[2],this.figures.forEach((s,o)=>s.move(e.x[o],ZI(o,t)));const n=this.figures[0];if(Math.hypot(n.x,n.z)>3){const s=a=>-Math.round(a/Eo)*Eo,[o,r]=[s(n.x),s(n.z)];for(const a of this.figures)a.shift(o,r);this.centre.add(new te(o,0,r))}this.show(e.f[0],e.f[1],e.x[0][0],e.x[0][4])}show(e,t,n,s){const o=this.look,r=this.figures[0].root.position;if(this.arrow.visible=Math.abs(e)>.005,!this.arrow.visible)return;const a=Math.min(.04+Math.abs(e)/o.weight*this.size()*1.2,this.size()*1.6),l=new te(Math.cos(s),0,-Math.sin(s)).multiplyScalar(Math.sign(e)),c=t*Math.sin(n),h=new te(r.x+c*Math.cos(s),o.wheel_radius+t*Math.cos(n),r.z-c*Math.sin(s)),u=o.body_depth/2+.004;this.arrow.position.copy(h).addScaledVector(l,-a-u),this.arrow.quaternion.setFromUnitVectors(new te(0,1,0),l);const[d,p]=[this.size()*.014,Math.min(a*.6,this.size()*.13)];this.shaft.scale.set(d,a-p,d),this.shaft.position.y=(a-p)/2,this.head.scale.set(3*d,p,3*d),this.head.position.y=a-p/2}draw(e){const{clientWidth:t,clientHeight:n}=this.canvas;if(!t||!n)return;this.pace(e);const s=Math.min(devicePixelRatio,2)*this.detail,o=this.renderer.getDrawingBufferSize(new vt);(Math.abs(o.x-t*s)>1||Math.abs(o.y-n*s)>1)&&(this.renderer.setPixelRatio(s),this.renderer.setSize(t,n,!1),this.camera.aspect=t/n,this.camera.updateProjectionMatrix(),this.stale=!0),this.stale&&(this.stale=this.follow(e),this.pull(),this.renderer.render(this.scene,this.camera))}pace(e){this.slow=e>45?this.slow+1:Math.max(0,this.slow-.5),this.slow>40&&this.detail>.8&&(this.detail*=.75,this.slow=0)}follow(e){const t=this.figures[0],n=this.size();t&&this.centre.lerp(new te(t.x,0,t.z),this.calm.matches?1:1-Math.exp(-e/QI));const s=this.camera.aspect<1?1.25:1,o=n*3.5*this.eye.away*s,{azimuth:r,height:a}=this.eye,l=o*Math.cos(a);this.ground.updateMatrixWorld();const c=this.ground.localToWorld(this.centre.clone()),h=c.clone().setY(c.y+n*.42);this.camera.position.set(h.x+l*Math.sin(r),h.y+o*Math.sin(a),h.z+l*Math.cos(r)),this.camera.lookAt(h),this.sun.position.set(c.x-n*2,c.y+n*5,c.z+n*2.4),this.sun.target.position.copy(c);const u=d=>Math.round(d/Eo)*Eo;return this.floor.position.set(u(this.centre.x),0,u(this.centre.z)),t?Math.hypot(t.x-this.centre.x,t.z-this.centre.z)>.001:!1}picture(e){const{clientWidth:t,clientHeight:n}=this.canvas;this.renderer.setPixelRatio($f/t),this.renderer.setSize(t,n,!1),this.renderer.render(this.scene,this.camera);const{width:s,height:o}=this.canvas,[r,a]=[document.createElement("canvas"),Math.round($f/28)];Object.assign(r,{width:s,height:o+a});const l=r.getContext("2d"),c=getComputedStyle(document.documentElement);return l.fillStyle=c.getPropertyValue("--card"),l.fillRect(0,0,s,o+a),l.drawImage(this.canvas,0,0),Object.assign(l,{fillStyle:c.getPropertyValue("--ink"),font:`${.45*a}px system-ui, sans-serif`,textBaseline:"middle"}),l.fillText(e,.4*a,o+a/2,s-.8*a),this.stale=!0,this.draw(0),new Promise(h=>r.toBlob(h))}turn(e,t){this.stale=!0,this.eye.azimuth+=e,this.eye.height=Math.min(1.2,Math.max(.03,this.eye.height+t))}zoom(e){this.stale=!0,this.eye.away=Math.min(3,Math.max(.45,this.eye.away*e))}grasp(){const e=this.look;if(!e)return{x:0,y:0};const t=this.figures[0].body.localToWorld(new te(0,e.body_height*.6,0)).project(this.camera);return{x:(t.x+1)/2*this.canvas.clientWidth,y:(1-t.y)/2*this.canvas.clientHeight}}pointer(e){const t=this.canvas.getBoundingClientRect();return new vt((e.clientX-t.left)/t.width*2-1,1-(e.clientY-t.top)/t.height*2)}ray(e){const t=new KI;return t.setFromCamera(e,this.camera),t}listen(){this.canvas.addEventListener("pointerdown",e=>this.down(e)),this.canvas.addEventListener("pointermove",e=>this.moved(e));for(const e of["pointerup","pointercancel","lostpointercapture"])this.canvas.addEventListener(e,()=>this.up());this.canvas.addEventListener("wheel",e=>{e.preventDefault(),this.zoom(Math.exp(e.deltaY/900))},{passive:!1})}down(e){if(!this.look||!this.figures.length)return;this.canvas.setPointerCapture(e.pointerId);const t=this.pointer(e),n=this.ray(t).intersectObject(this.figures[0].root,!0)[0];if(!n){this.turning={x:e.clientX,y:e.clientY};return}const s=this.figures[0].body.worldToLocal(n.point.clone());this.grip={at:s,mouse:t,height:Math.max(0,s.y)},this.pull(),this.canvas.classList.add("holding")}moved(e){this.turning&&(this.turn((this.turning.x-e.clientX)/160,(e.clientY-this.turning.y)/260),this.turning={x:e.clientX,y:e.clientY}),this.grip&&(this.grip.mouse=this.pointer(e),this.pull())}pull(){const[e,t]=[this.grip,this.look];if(!e||!t)return;const n=this.figures[0],s=n.body.localToWorld(e.at.clone()),o=this.camera.position.clone().sub(s).setY(0).normalize(),r=new rs().setFromNormalAndCoplanarPoint(o,s),a=this.ray(e.mouse).ray.intersectPlane(r,new te);if(!a)return;const l=n.root.rotation.y,c=a.sub(s).dot(new te(Math.cos(l),0,-Math.sin(l)).applyQuaternion(this.ground.quaternion));this.push({force:qm(c,t),height:e.height})}up(){this.turning=null,this.grip&&(this.grip=null,this.canvas.classList.remove("holding"),this.push({force:0,height:0}))}}const i3="http://www.w3.org/2000/svg",To=170,s3=110,qf=600;class o3{constructor(e){this.push=e,this.element.addEventListener("pointerdown",t=>this.down(t)),this.element.addEventListener("pointermove",t=>this.moved(t));for(const t of["pointerup","pointercancel"])this.element.addEventListener(t,()=>this.up())}element=qn("svg",{viewBox:"-200 0 400 200",class:"room flat",role:"img",tabindex:"0"});sides=[];ground=qn("g");arrow=qn("path",{class:"arrow"});look=null;grip=null;paint(){}furnish(e,t){this.look=e,this.element.replaceChildren(this.ground),this.ground.replaceChildren(qn("line",{x1:-qf,x2:qf,y1:To,y2:To,class:"ground"})),this.sides=t.map((n,s)=>this.side(e,n,s>0)).reverse();for(const n of this.sides)this.ground.append(n.root);this.sides.reverse(),this.ground.append(this.arrow)}scale(e){return s3/(Math.max(e.body_height,e.payload>0?e.payload_height:0)+e.wheel_radius)}side(e,t,n){const s=this.scale(e),[o,r,a]=[e.wheel_radius*s,e.body_height*s,e.body_depth*s],l=n?{fill:"none",stroke:cs(t),"stroke-width":2,opacity:.7}:{},c=n?{}:{fill:cs(t)},h=qn("g");if(h.append(qn("rect",{x:-a/2,y:-r-o*.25,width:a,height:r,rx:3,class:n?"":"shell",...l,...c})),e.payload>0&&!n){const[p,g]=[Math.cbrt(e.payload/2500)*s,e.payload_height*s];h.append(qn("path",{d:`M0 0V${-g}`,class:"carrier"}),qn("rect",{x:-p/2,y:-g-p/2,width:p,height:p,class:"payload"}))}const u=qn("g");u.append(qn("circle",{r:o,class:n?"":"tyre",...l}),qn("path",{d:`M${-o*.6} 0H${o*.6}M0 ${-o*.6}V${o*.6}`,class:n?"":"spokes",...l}));const d=qn("g");return d.append(h,u),{root:d,body:h,wheel:u}}move(e){const t=this.look;if(!t||e.x.length!==this.sides.length)return;const n=this.scale(t),s=180/Math.PI;this.ground.setAttribute("transform",`rotate(${-e.f[2]*s} 0 ${To})`),this.sides.forEach((u,d)=>{const[p,,g]=e.x[d],_=(g-e.x[0][2])*t.wheel_radius*n;u.root.setAttribute("transform",`translate(${_} ${To-t.wheel_radius*n})`),u.body.setAttribute("transform",`rotate(${p*s})`),u.wheel.setAttribute("transform",`rotate(${g*s})`)});const[o,r]=e.f,a=o/t.weight*150,[l,c]=[r*Math.sin(e.x[0][0])*n,To-(t.wheel_radius+r*Math.cos(e.x[0][0]))*n],h=Math.sign(o)*7;this.arrow.setAttribute("d",Math.abs(o)>.005?`M${l-a-h} ${c}H${l}m${-h} -5L${l} ${c}l${-h} 5`:"")}draw(){}picture(){return Promise.resolve(new Blob([new XMLSerializer().serializeToString(this.element)],{type:"image/svg+xml"}))}turn(){}zoom(){}grasp(){const e=(this.sides[0]?.body.firstElementChild??this.element).getBoundingClientRect(),t=this.element.getBoundingClientRect();return{x:e.x-t.x+e.width/2,y:e.y-t.y+e.height*.4}}down(e){const t=this.sides[0];if(!this.look||!t?.root.contains(e.target))return;this.element.setPointerCapture(e.pointerId);const n=this.element.getBoundingClientRect().height/200,s=this.element.getBoundingClientRect().y+(To-this.look.wheel_radius*this.scale(this.look))*n;this.grip={x:e.clientX,height:Math.max(0,(s-e.clientY)/n/this.scale(this.look))},this.push({force:0,height:this.grip.height})}moved(e){if(!this.grip||!this.look)return;const t=this.scale(this.look)*this.element.getBoundingClientRect().height/200;this.push({force:qm((e.clientX-this.grip.x)/t,this.look),height:this.grip.height})}up(){this.grip&&(this.grip=null,this.push({force:0,height:0}))}}function qn(i,e={}){const t=document.createElementNS(i3,i);for(const[n,s]of Object.entries(e))s!==""&&t.setAttribute(n,String(s));return t}const Xf=.25,jf=1.5,r3=.12,a3=.15;class l3{held=new Set;last="";asked=0;padded=!1;constructor(){window.addEventListener("keydown",e=>this.down(e)),window.addEventListener("keyup",e=>this.up(e)),window.addEventListener("blur",()=>this.release())}down(e){const t=e.target;e.repeat||e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA)$/.test(t.tagName)||t.getAttribute("role")==="tab"||t.closest("dialog")||/^(Arrow(Up|Down|Left|Right)|f|b)$/.test(e.key)&&(e.preventDefault(),this.held.add(e.key),this.push(),this.steer(...this.keys()))}up(e){this.held.delete(e.key)&&(this.push(),this.steer(...this.keys()))}release(){this.held.size&&(this.held.clear(),this.push(),this.steer(0,0))}keys(){const e=t=>this.held.has(t)?1:0;return[Xf*(e("ArrowUp")-e("ArrowDown")),jf*(e("ArrowLeft")-e("ArrowRight"))]}pushing=!1;push(){const e=(this.held.has("b")?1:0)-(this.held.has("f")?1:0);if(!e&&!this.pushing)return;this.pushing=e!==0;const t=R.changed?.look;R.push({kind:"Drag",force:e*r3*(t?.weight??6),height:t?.com_height??.07})}steer(e,t){const n=`${e.toFixed(2)} ${t.toFixed(2)}`;n!==this.last&&(this.last=n,R.send({kind:"Steer",speed:e,rate:t}))}tick(e){if(e-this.asked<60)return;this.asked=e;const t=navigator.getGamepads?.().find(s=>s?.connected);if(this.held.size||!t&&!this.padded)return;this.padded=!!t;const n=s=>{const o=t?.axes[s]??0;return Math.abs(o)<a3?0:-o};this.steer(Xf*n(1),jf*n(0))}}const c3=[.2,3/8,5/9,2/3],h3=(i,e)=>t=>{const n=4*i+t-4,s="*-04-39?2$%%$%%'$%''%'''%')(%'))%(++'(++'(+.'+-.',/3',33)-/5)-43).36)058*18<+37<+4:<,4:E,5<A-7>C/8@F/:EH/<EK0=FM1?IP2@KS3BNV4DPY5FS\\6HV_6IXb7K[e8N^i9Pam;Rdp<Tgt".charCodeAt(n)-35,o=n>8?s:1,r=e/o|0,a=e%o,l=o-a,c=n>8?r*c3[t]+(i>5)&-2:s,h=r-c;return{t:l*h+a*h+a,o:[[l,h],[a,h+1]],i:c}},Yf={M:1},Zs=i=>new Uint8Array(i),br=i=>{const e=new Error(`lean-qr error ${i}`);throw e.code=i,e},_a=i=>"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:".indexOf(i),dh=i=>i.charCodeAt(0),Xm=(...i)=>(e,t)=>i.forEach(n=>n(e,t)),jm=i=>e=>{e.eci!==i&&(e.push(7,4),i<128?e.push(i,8):i<16384?e.push(32768|i,16):e.push(12582912|i,24),e.eci=i)},tu=i=>(e,t)=>{e.push(4,4),e.push(i.length,8+8*(t>9)),i.forEach(n=>e.push(n,8))},Jo=(i,e,t,n,s=(r,a)=>t(r.length,a),o=n?r=>Xm(jm(n),i(r)):i)=>(o.test=e,o.l=t,o.est=s,o.eci=n&&[n],o),Ym=Jo(i=>(e,t)=>{e.push(1,4),e.push(i.length,10+2*(t>26)+2*(t>9));let n=0;for(;n<i.length-2;n+=3)e.push(+i.slice(n,n+3),10);n<i.length-1?e.push(+i.slice(n),7):n<i.length&&e.push(+i[n],4)},i=>/[0-9]/.test(i),(i,e)=>14+2*(e>26)+2*(e>9)+10*i/3),Km=Jo(i=>(e,t)=>{e.push(2,4),e.push(i.length,9+2*(t>26)+2*(t>9));let n=0;for(;n<i.length-1;n+=2)e.push(45*_a(i[n])+_a(i[n+1]),11);n<i.length&&e.push(_a(i[n]),6)},i=>_a(i)>=0,(i,e)=>13+2*(e>26)+2*(e>9)+5.5*i),$o=Jo(i=>tu([...i].map(dh)),i=>dh(i)<128,(i,e)=>12+8*(e>9)+8*i);$o._=!0,$o.u=!0;const nu=Jo($o,i=>dh(i)<256,$o.l,3);nu._=!0;const Kf=new TextEncoder,iu=Jo(i=>tu(Kf.encode(i)),()=>1,0,26,(i,e)=>12+8*(e>9)+8*Kf.encode(i).length);iu._=!0;let fh=()=>{const i=new Map,e=new TextDecoder("sjis"),t=Zs(2);for(let n=0;n<7973;++n)t[0]=n/192+129+64*(n>5951),t[1]=n%192+64,i.set(e.decode(t),n);return i.delete("�"),fh=()=>i,i};const su=Jo(i=>(e,t)=>{e.push(8,4),e.push(i.length,8+2*(t>26)+2*(t>9));for(const n of i)e.push(fh().get(n),13)},i=>fh().has(i),(i,e)=>12+2*(e>26)+2*(e>9)+13*i);su._=!0;const Zm=[Ym,Km,$o,nu,su,iu],u3={auto:(i,{modes:e=Zm}={})=>(t,n)=>{const s=e.map((h,u)=>{const d=new Map,p=(g,_)=>(d.has(g)||d.set(g,_(g,n)),d.get(g));return{m:h,h:1<<u,C:h.est("",n),S:h.l?(g,_)=>p(_-g,h.l):(g,_)=>p(i.slice(g,_),h.est)}});let o=[{v:0}],r=0,a=0,l=-1;for(const h of[...i,""]){let u=0;if(h)for(const d of s)d.m.test(h)&&(u|=d.h);if(!h||u!==l){if(l!==-1){const d=new Set(o.map(g=>g.D)),p=[];for(const{m:g,C:_,S:m,h:f}of s)if(l&f){const M=m(r,a);for(const S of g.eci??d)if(!g.u||!S){let b;for(const F of o)if(F.D===S||g.eci){const L=F.m===g&&F.D===S,A=L?F.V:F,U=g._&&L?F.v+M-_:A.v+12*(A.D!==S)+(L?m(L?F.$:r,a):M);(!b||U<b.v)&&(b={$:L?F.$:r,V:A,m:g,D:S,A:a,v:U})}b&&p.push(b)}}o=p}l=u,r=a}a+=h.length}o.length||br(5);const c=[];for(let h=o.reduce((u,d)=>d.v<u.v?d:u);h.m;h=h.V)c.push(h.m(i.slice(h.$,h.A)));c.reverse().forEach(h=>h(t,n))},multi:Xm,eci:jm,bytes:tu,numeric:Ym,alphaNumeric:Km,ascii:$o,iso8859_1:nu,shift_jis:su,utf8:iu},d3=()=>({F:Zs(2956),I:0,push(i,e){for(let t=e,n=8-(7&this.I);t>0;t-=n,n=8)this.F[this.I>>3]|=i<<n>>t,this.I+=t<n?t:n}}),rc=(i,e=i*i,t=Zs(e))=>({size:i,K:t,get:(n,s)=>n>=0&&n<i&&!!(1&t[s*i+n]),toString({on:n="##",off:s="  ",lf:o=`
`,pad:r=4,padX:a=r,padY:l=r}={}){let c="";for(let h=-l;h<i+l;++h){for(let u=-a;u<i+a;++u)c+=this.get(u,h)?n:s;c+=o}return c},toImageData(n,{on:s=[0,0,0],off:o=[0,0,0,0],pad:r=4,padX:a=r,padY:l=r}={}){const c=i+2*a,h=i+2*l,u=n.createImageData(c,h),d=new Uint32Array(u.data.buffer);u.data.set([...s,255]);const p=d[0];u.data.set([...o,255]);const g=d[0];for(let _=0;_<h;++_)for(let m=0;m<c;++m)d[_*c+m]=this.get(m-a,_-l)?p:g;return u},toCanvas(n,s){const o=n.getContext("2d"),r=this.toImageData(o,s);n.width=r.width,n.height=r.height,o.putImageData(r,0,0)},toDataURL({type:n="image/png",scale:s=1,...o}={}){const r=document.createElement("canvas"),a=r.getContext("2d"),l=this.toImageData(a,o);return r.width=l.width*s,r.height=l.height*s,a.putImageData(l,0,0),a.imageSmoothingEnabled=!1,a.globalCompositeOperation="copy",a.drawImage(r,0,0,l.width,l.height,0,0,r.width,r.height),r.toDataURL(n,1)}}),va=[(i,e)=>1&(i^e),(i,e)=>1&e,i=>i%3,(i,e)=>(i+e)%3,(i,e)=>1&(i/3^e>>1),(i,e)=>(i&e&1)+i*e%3,(i,e)=>(i&e)+i*e%3&1,(i,e)=>(i^e)+i*e%3&1],$a=Zs(511);for(let i=0,e=1;i<255;e=2*e^285*(e>127))$a[$a[e+255]=i++]=e;const Jm=i=>$a[i%255],Qm=i=>$a[i+255],f3=(i,e)=>{const t=Zs(i.length+e.length-1);for(let n=0;n<i.length;++n)for(let s=0;s<e.length;++s)t[n+s]^=Jm(i[n]+e[s]);return t.map(Qm)},p3=(i,e)=>{const t=Zs(i.length+e.length-1);t.set(i,0);for(let n=0;n<i.length;++n)if(t[n]){const s=Qm(t[n]);for(let o=0;o<e.length;++o)t[n+o]^=Jm(e[o]+s)}return t.slice(i.length)},ph=[[0],[0,0]];for(let i=1;i<30;++i)ph.push(f3(ph[i],[0,i]));const m3=(i,e)=>{const t=[[],[]];let n=0,s=0;for(const[r,a]of e.o)for(let l=0;l<r;++l,n+=a){const c=i.slice(n,n+a);t[0].push(c),t[1].push(p3(c,ph[e.i])),s+=a+e.i}const o=Zs(s);s=0;for(const r of t)for(let a=0,l=-1;l<s;++a){l=s;for(const c of r)a<c.length&&(o[s++]=c[a])}return o},eg=(i,e,t)=>{let n=i<<=t;for(let s=134217728;s>>=1;)n&s&&(n^=e*(s>>t));return n|i},g3=({size:i,K:e},t)=>{const n=(r,a,l,c)=>{for(;l-- >0;r+=i)e.fill(c,r,r+a)},s=(r,a,l)=>{for(let c=0;c++<3;l-=2)n(a*i+r-(l>>1)*(i+1),l,l,2|c)},o=2*((i-13)/(1+(t/7|0))/2+.75|0);if(t>1)for(let r=i-7;r>8;r-=o){for(let a=r;a>8;a-=o)s(r,a,5);r<i-7&&s(r,6,5)}if(t>6)for(let r=eg(t,7973,12),a=1;a<7;++a)for(let l=12;l-- >9;r>>=1)e[a*i-l]=2|1&r;n(7,2,9,2),n(i-8,8,9,2);for(let r=0;r<i;++r)e[6*i+r]=3^1&r;s(3,3,7),s(i-4,3,7);for(let r=0;r<i;++r)for(let a=r;a<i;++a)e[a*i+r]=e[r*i+a];e[(i-8)*i+8]=3},_3=({size:i,K:e})=>{const t=[];for(let n=i-2,s=i,o=-1;n>=0;n-=2){for(n===5&&(n=4);s+=o,s!==-1&&s!==i;){const r=s*i+n;e[r+1]||t.push(r+1),e[r]||t.push(r)}o*=-1}return t},v3=({K:i},e,t)=>e.forEach((n,s)=>i[n]=t[s>>3]>>(7&~s)&1),b3=({size:i,K:e},t,n,s)=>{for(let r=0;r<i;++r)for(let a=0;a<i;++a){const l=r*i+a;e[l]^=!(t(a,r)||2&e[l])}let o=21522^eg((1^s)<<3|n,1335,10);for(let r=0;r++<8;o>>=1)e[(r-(r<7))*i+8]=1&o,e[9*i-r]=1&o;for(let r=8;--r,o;o>>=1)e[8*i+r-(r<7)]=1&o,e[(i-r)*i+8]=1&o},y3=({size:i,K:e},t=0,n=0)=>{for(let s=0;s<i;++s){for(let o=0;o<2;++o)for(let r,a=0,l=0,c=2;a<i;++a){const h=1&e[o?s*i+a:a*i+s];n+=h,l=(l>>1|2098176)&(3047517^h-1),2049&l&&(t+=40),h^c&&(r=0),c=h,t+=++r===5?3:r>5}if(s)for(let o=i+s,r=5*e[s-1]^e[s];o<i*i;o+=i){const a=5*e[o-1]^e[o];t+=3*!(1&(r|a)|4&(r^a)),r=a}}return t+10*(10*Math.abs(n/(i*i)-1)|0)},Zf=[],mh=(i=br(1),{minCorrectionLevel:e=0,maxCorrectionLevel:t=3,minVersion:n=1,maxVersion:s=40,mask:o,trailer:r=60433,...a}={})=>{t<e&&br(3),s<n&&br(2),typeof i=="string"&&(i=u3.auto(i,a));for(let l=n,c=0;l<=s;++l){let h=Zf[l];h||(Zf[l]=h=rc(4*l+17),g3(h,l),h.p=_3(h));const u=h3(l,h.p.length>>3);if(8*u(e).t<c)continue;const d=d3();i(d,l),c=d.I;for(let p=t;p>=e;--p){const g=u(p);if(8*g.t<c)continue;for(d.I=c+11&-8;d.I<8*g.t;)d.push(r,16);const _=rc(h.size,h.K);return v3(_,h.p,m3(d.F,g)),(va[o]?[va[o]]:va).map((m,f)=>{const M=rc(_.size,_.K);return b3(M,m,o??f,p),M.s=va[o]?0:y3(M),M}).reduce((m,f)=>f.s<m.s?f:m)}}br(4)};mh.with=(...i)=>(e,t)=>mh(e,{modes:[...Zm,...i],...t});const ac="http://www.w3.org/2000/svg",dr=4;function x3(i,e){const t=mh(i,{minCorrectionLevel:Yf.M,maxCorrectionLevel:Yf.M}),n=document.createElementNS(ac,"svg"),s=t.size+2*dr;n.setAttribute("viewBox",`${-dr} ${-dr} ${s} ${s}`),n.setAttribute("class","qr"),n.setAttribute("role","img"),n.setAttribute("aria-label",e);const o=document.createElementNS(ac,"rect");for(const[l,c]of Object.entries({x:-dr,y:-dr,width:s,height:s,fill:"#ffffff"}))o.setAttribute(l,String(c));const r=document.createElementNS(ac,"path");let a="";for(let l=0;l<t.size;l+=1)for(let c=0;c<t.size;c+=1)t.get(c,l)&&(a+=`M${c} ${l}h1v1h-1z`);return r.setAttribute("d",a),r.setAttribute("fill","#000000"),r.setAttribute("shape-rendering","crispEdges"),n.append(o,r),n}const Jf="http://www.w3.org/2000/svg";class M3{root=D("div",{className:"panel-body"});wall=D("div",{className:"wall"});scores=D("div",{className:"table"});build(){const e=D("div",{className:"column wide"});R.role==="teacher"&&e.append(D("div",{className:"row"},st(N("broadcast"),()=>R.send({kind:"Broadcast",setup:R.setup}),{className:"main","data-key":"broadcast"}),st(N("results"),()=>E3(w3()),{"data-key":"results"})),S3(),this.wall),e.append(this.scores),$e(this.root,e),this.update()}update(){const e=R.board?.students??[];$e(this.wall,...e.map(T3));const t=D("thead",{},D("tr",{},...["",N("name"),N("bestPush"),N("effort"),N("family")].map(s=>D("th",{scope:"col"},s)))),n=e.map((s,o)=>D("tr",{className:s.here?"":"away"},D("td",{},String(o+1)),D("td",{},s.name),D("td",{},oi(s.best,3)),D("td",{},oi(s.effort,0)),D("td",{},fn(s.controller).split(":")[0])));$e(this.scores,D("table",{className:"board","aria-label":N("board")},t,D("tbody",{},...n)))}}function S3(){const i=new URL(`#token=${R.invite}`,location.href.split("#")[0]).href;return D("figure",{className:"invite"},x3(i,N("invite")),D("figcaption",{},D("b",{},N("invite")),D("code",{},i)))}function w3(){const i=t=>`"${t.replace(/^[=+\-@\t]/,"'$&").replaceAll('"','""')}"`;return["place,name,best_push_Ns,effort_u2s,controller,here",...(R.board?.students??[]).map((t,n)=>[n+1,i(t.name),t.best.toFixed(4),t.effort.toFixed(1),i(t.controller),t.here].join(",")),""].join(`\r
`)}function E3(i){const e=URL.createObjectURL(new Blob(["\uFEFF",i],{type:"text/csv"}));D("a",{href:e,download:"results.csv"}).click(),window.setTimeout(()=>URL.revokeObjectURL(e),1e4)}function T3(i){const e=document.createElementNS(Jf,"svg");e.setAttribute("viewBox","-30 -48 60 60"),e.setAttribute("aria-hidden","true");const t=(s,o)=>{const r=document.createElementNS(Jf,s);for(const[a,l]of Object.entries(o))r.setAttribute(a,l);e.append(r)},n=(i.pitch*180/Math.PI).toFixed(1);return t("rect",{x:"-6",y:"-40",width:"12",height:"38",rx:"3",class:"stick",transform:`rotate(${n})`}),t("circle",{r:"8",cx:"0",cy:"0",class:"wheel"}),t("line",{x1:"-30",x2:"30",y1:"8.5",y2:"8.5",class:"ground"}),D("figure",{className:`tile${i.fallen?" down":""}${i.here?"":" away"}`},e,D("figcaption",{},i.name))}const Ps=["twin","nonlinear","linear"],A3=[{setup:{},lean:0,acts:[.05,.3,"size"]},{setup:{controller:"off",bodies:Ps},lean:el,speed:.1,ceiling:.3},{setup:{controller:"off",kit:"ideal",bodies:["nonlinear","linear"]},lean:.03,speed:.1},{setup:{controller:"lqr",bodies:Ps},lean:.1,acts:["tilt"]},{setup:{controller:"lqg",bodies:Ps},lean:0,strike:"front"},{setup:{controller:"lqg",bodies:Ps},lean:0,strike:"back",acts:["curves"]},{setup:{controller:"lqg",bodies:Ps},lean:0,strike:"front",live:!0,acts:["identify"]},{setup:{controller:"lqr",bodies:Ps,payload:.2,payload_height:.3},lean:0,acts:[.05,.3]},{setup:{controller:"robust",bodies:Ps,payload:.2,payload_height:.3},lean:0,live:!0,acts:[.05,.3,"tilt"]}],fr=A3.map((i,e)=>({scene:i,i:e})).filter(({scene:i})=>!(Yt&&i.live));class R3{constructor(e){this.tools=e}root=D("div",{className:"panel-body tour"});at=0;before=null;awaits=!1;build(){const{i:e,scene:t}=fr[this.at],{here:n,...s}=Ph().tour[e],o=e===0&&!R.setup.bodies.includes("twin"),r={...s,...(Yt||o)&&n},a=(c,h,...u)=>D("div",{className:"hint-part"},D("h4",{},c),D("p",{},h),...u),l=(t.acts??[]).map(c=>this.control(c));$e(this.root,D("div",{className:"column wide"},D("p",{className:"note"},N("tourStep",{n:this.at+1,all:fr.length})),D("h3",{},r.title),D("div",{className:"hints"},a(N("tourDo"),r.do,D("div",{className:"acts"},...l)),a(N("tourWatch"),r.watch),a(N("tourAsk"),r.ask)),D("div",{className:"row"},st(N("previous"),()=>this.move(-1,"previous"),{disabled:this.at===0,"data-key":"tour-previous"}),this.at||this.before?st(N("tourSet"),()=>this.set(),{className:this.at?"main":"","data-key":"tour-set"}):null,st(N("next"),()=>this.move(1,"next"),{className:this.at?"":"main",disabled:this.at===fr.length-1,"data-key":"tour-next"})),this.before?st(N("tourBack"),()=>this.back(),{className:"quiet","data-key":"tour-back"}):null))}control(e){const{knock:t,sizer:n,tilt:s,curves:o,identify:r}=this.tools,a={"data-key":`act-${e}`};if(typeof e=="number")return st(Ar(N("mark_impulse",{size:e.toFixed(2)})),()=>t(e),a);switch(e){case"size":return n();case"tilt":return st(N("tilt"),s,{...a,title:N("tiltTip")});case"curves":return st(N("moreCurves"),o,a);case"identify":return st(N("tabIdentify"),r,a)}}move(e,t="set"){this.at=Math.min(Math.max(this.at+e,0),fr.length-1),this.build();const n=o=>this.root.querySelector(`[data-key=tour-${o}]:enabled`);(n(t)??n("set")??n("next"))?.focus({preventScroll:Gs.matches});const s=this.root.parentElement;s&&(s.scrollTop=0),Gs.matches&&this.upward(s?.parentElement?.querySelector(".tabs"))}upward(e){if(!e)return;const t=Math.max(...[e,document.documentElement].map((n,s)=>parseFloat(getComputedStyle(n)[s?"scrollPaddingTop":"scrollMarginTop"])||0));this.root.getBoundingClientRect().top<t+e.clientHeight&&(t?e:e.parentElement)?.scrollIntoView()}back(){this.before&&R.change(this.before),R.last.name(null),this.before=null,this.tools.run(1),R.send({kind:"StandUp",pitch:0}),this.build()}designed(){const e=this.awaits&&R.setup.controller==="robust";return this.awaits=!1,e&&R.send({kind:"StandUp",pitch:0}),e}set(){const{setup:e,lean:t,speed:n,strike:s,ceiling:o}=fr[this.at].scene;this.before||(this.before=R.setup,this.build(),this.root.querySelector("[data-key=tour-set]")?.focus()),R.anew(()=>{this.tools.run(n??1),R.change({...Gi,...e}),R.ceiling=o??null,R.send({kind:"StandUp",pitch:t})}),this.awaits=e.controller==="robust",s&&window.setTimeout(()=>R.send({kind:"Strike",what:s,size:s==="front"?.1:-.12}),1e3)}}const Qf=["Tour","Controller","Robot","Kit","See","Identify","Keep","Class","Python"],ep=["Tour","Controller","Robot","See","Keep","Python"],C3=.19,lc=[.01,.5],P3=10,L3=1e-6,N3=1500,D3=400;function I3(){const i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=i?.getParameter(e?.UNMASKED_RENDERER_WEBGL??i.RENDERER);return i?.getExtension("WEBGL_lose_context")?.loseContext(),{able:i!==null,quick:!/swiftshader|llvmpipe|software|basic render/i.test(t)}}class k3{constructor(e){this.app=e,this.theme(os.getItem("theme")??"");const t=new URLSearchParams(location.hash.slice(1)).get("lang")??"";hd(Object.hasOwn(wr,t)?t:os.getItem("language")??(navigator.language.startsWith("es")?"es":"en")),R.listen(n=>this.hear(n)),R.say=(n,s="info")=>this.toast(n,s),R.corrected=()=>this.toasts.querySelectorAll(".toast.error").forEach(n=>n.remove()),this.scrub.addEventListener("input",()=>R.send({kind:"Scrub",back:Number(this.scrub.max)-Number(this.scrub.value)})),this.equip(),this.measure("--toasts",this.toasts),this.measure("--fell",this.fell,8),window.addEventListener("keydown",n=>this.key(n)),window.addEventListener("hashchange",()=>R.recorded||this.link()),this.begin()}deeper=null;room=this.furnish();charts=new dR(()=>P3*this.speed);see=new AC;controller=new FC;local=null;robot=Yt?new mC(()=>this.local):new OC;python=new gC;kit=new zC;identify=new HC;keep=new VC(()=>this.picture());tour=new R3({run:e=>(this.greeted(),this.run(e)),knock:e=>(this.sizeTo(e),this.strike()),sizer:()=>this.sizer("act-size").root,tilt:()=>this.tilt(),curves:()=>this.charts.more(),identify:()=>this.bring("Identify")});classes=new M3;newcomer=!os.getItem("toured")&&!ka(location.hash);tab=this.newcomer?"Tour":"Controller";knock=.05;sizers=[];sized=D("span",{className:"of"});speed=1;scrub=D("input",{type:"range",min:"-60",max:"0",step:"0.02",value:"0",className:"scrub","data-key":"scrub"});pauseButton=D("button",{type:"button","data-key":"pause"});status=D("span",{className:"status",role:"status"});light=D("button",{type:"button",className:"headlight","data-key":"headlight",onclick:()=>this.certificate()});force=D("div",{className:"force","aria-hidden":"true"});fell=D("div",{className:"fell",role:"status"});toasts=D("div",{className:"toasts",role:"log","aria-live":"polite"});spoken=D("p",{className:"hidden","aria-live":"off"});tabs=D("div",{className:"tabs",role:"tablist"});panel=D("div",{className:"panel",role:"tabpanel",tabIndex:-1,id:"panel"});clock=D("span",{className:"clock"});state="connecting";drawn=0;down=null;lost=null;best={};most=D("span",{className:"most"});telling=0;waits=0;busy=!1;prepared=!1;begun=!1;timing=!1;drawnFirst=!1;seen=0;plotted=0;said=0;shape="";steering=new l3;pinned=null;begin(){const e=Bd.inPage(),t=WA(location.hash)||(Fi.getItem("token")??"");t&&Fi.setItem("token",t),location.hash.includes("token=")&&history.replaceState(null,"",location.pathname),this.build(),Yt?(document.body.classList.add("exported"),this.local=new lC(Yt),this.link(),this.says("connected")):e?(this.says("replaying"),new Bd(e),document.body.classList.add("replay")):t&&!Fi.getItem("name")&&t.length<12?this.join(t):this.connect(t,Fi.getItem("name")??""),requestAnimationFrame(n=>this.frame(n))}connect(e,t){new vC({token:e,name:t},(n,s)=>this.says(n,s))}join(e){const t=D("input",{type:"text",id:"name",maxLength:40,required:!0,autocomplete:"name"}),n=D("dialog",{className:"join","aria-label":N("joinTitle")},D("form",{method:"dialog",onsubmit:s=>{s.preventDefault(),t.value.trim()&&(Fi.setItem("name",t.value.trim()),n.remove(),this.connect(e,t.value.trim()))}},D("h2",{},N("joinTitle")),D("label",{for:"name"},N("yourName")),t,D("button",{className:"main"},N("enter"))));this.app.append(n),n.showModal()}build(){const e=Object.entries(wr).map(([s,o])=>[s,o.language]),t=D("header",{},D("a",{className:"skip",href:"#panel",onclick:()=>this.panel.focus()},N("skip")),D("h1",{},D("span",{className:"mark","aria-hidden":"true"}),N("title")),D("p",{className:"what"},N("what")),this.light,D("span",{className:"grow"}),this.clock,this.status,Yt?_C(s=>this.toast(s,"info")):null,fs("",e,Hp(),s=>this.speak(s),"language"),st("◐",()=>this.theme(document.documentElement.dataset.theme==="dark"?"light":"dark"),{"aria-label":N("theme"),title:N("theme"),"data-key":"theme"}),st("?",()=>this.help(),{"aria-label":N("help"),title:N("help"),"data-key":"help"}));t.querySelector("select")?.setAttribute("aria-label","Language / Idioma");const n=D("section",{className:"scene","aria-label":N("scene")},this.room.element,this.force,this.fell,D("p",{className:"hint"},D("span",{},N("hint")),this.invitation()),this.charts.slot,this.pushes(),this.transport());this.pin(n),$e(this.app,t,D("main",{},n,this.panels(),this.charts.root),this.toasts,this.spoken),this.lamp(),!R.snapshot&&!R.recorded&&this.tell(hn(()=>N("starting"))),R.changed&&this.rebuild()}pin(e){const n={rootMargin:`1000000px 0px ${C3*innerHeight+8*parseFloat(getComputedStyle(document.documentElement).fontSize)-innerHeight}px`},s=new IntersectionObserver(o=>e.classList.toggle("pinned",o.at(-1)?.isIntersecting??!1),n);this.pinned?.disconnect(),this.pinned=s,s.observe(this.tabs)}furnish(){const e=Dh(33,o=>R.push({kind:"Drag",force:o.force,height:o.height})),t=()=>new n3(D("canvas",{className:"room",tabIndex:0,role:"img"}),e),{able:n,quick:s}=I3();return n&&(s||!Yt)?t():(this.deeper=n?t:null,new o3(e))}measure(e,t,n=0){const s=()=>document.documentElement.style.setProperty(e,`${t.childElementCount&&t.offsetHeight+n}px`);new ResizeObserver(s).observe(t)}equip(){this.room.element.setAttribute("aria-label",N("scene")),this.room.element.addEventListener("keydown",e=>this.look(e))}deepen(){const[e,t]=[R.changed,this.room.element];!this.deeper||!e||R.snapshot?.f[0]||(this.room=this.deeper(),this.deeper=null,this.equip(),this.room.furnish(e.look,e.bodies),t.replaceWith(this.room.element),R.snapshot&&this.room.move(R.snapshot),this.room.draw(0))}link(){ka(location.hash)&&this.speed!==1&&this.run(1),dC();const[e,t]=R.last.push??["",0];e==="impulse"&&t>=lc[0]&&t<=lc[1]&&this.sizeTo(t)}run(e,t=!1){this.speed=e;const n=this.app.querySelector("[data-key=speed]");n&&(n.value=String(e)),R.send({kind:"Play",paused:t,speed:e})}transport(){this.pauseButton.onclick=()=>this.pause();const e=[["0.05","× 1/20"],["0.1","× 1/10"],["0.25","× 1/4"],["0.5","× 1/2"],["1","× 1"]],t=fs(N("speed"),e,String(this.speed),r=>this.run(Number(r),R.snapshot?.paused),"speed");t.querySelector("select")?.setAttribute("aria-label",N("speed"));const n=st(N("step"),()=>R.send({kind:"Step",periods:1}),{title:N("stepTip"),"data-key":"step"}),s=N(R.recorded?"timeLine":"back");this.scrub.setAttribute("aria-label",s),R.recorded&&([this.scrub.min,this.scrub.max]=["0",String(R.recorded)]);const o=st(N("standUp"),()=>this.stand(),{"data-key":"stand"});return D("div",{className:"transport"},this.pauseButton,n,o,t,D("label",{className:"scrubbing"},D("span",{},s),this.scrub))}pushes(){const e=(o,r)=>()=>R.push({kind:"Strike",what:o,size:r}),t=()=>R.changed?.look.weight??6,n=this.sizer("knock"),s=st(N("impulse"),()=>this.strike(),{title:N("impulseTip"),className:"main","data-key":"impulse"});return s.append(this.sized),n.root.insertBefore(this.most,n.root.lastChild),this.champion(),D("div",{className:"pushes",role:"group","aria-label":N("pushes")},s,n.root,st(N("front"),e("front",.1),{title:N("frontTip"),"data-key":"front"}),st(N("backPush"),e("back",-.12),{title:N("backTip"),"data-key":"back"}),st(N("pullLeft"),()=>e("pull_left",.25*t())(),{title:N("pullTip"),"data-key":"pull_left"}),st(N("pullRight"),()=>e("pull_right",.25*t())(),{title:N("pullTip"),"data-key":"pull_right"}),st(N("tilt"),()=>this.tilt(),{title:N("tiltTip"),"data-key":"tilt"}))}sizer(e){const[t,n]=lc,s=Zn(N("size"),{low:t,high:n,step:.01,show:o=>`${oi(o,2)} N s`,key:e},o=>this.sizeTo(o));return s.root.title=N("sizeTip"),this.sizers=[...this.sizers.filter(({root:o})=>o.isConnected),s],this.sizeTo(this.knock),s}sizeTo(e){this.knock=e;for(const t of this.sizers)t.set(e);this.sized.textContent=` ${oi(e,2)} N s`}strike(){R.push({kind:"Strike",what:"impulse",size:this.knock})}tilt(){R.send({kind:"StandUp",pitch:.1})}panels(){const e=Yt?ep:Qf.filter(n=>n!=="Python"&&(n!=="Class"||R.role!=="alone")),t={Controller:N("tabController"),Robot:N("tabRobot"),Kit:N("tabKit"),See:N("tabSee"),Identify:N("tabIdentify"),Keep:N("tabKeep"),Tour:N("tabTour"),Class:N("tabClass"),Python:N("tabPython")};return this.tabs.setAttribute("aria-label",N("tabs")),$e(this.tabs,...e.map(n=>st(t[n],()=>this.bring(n),{role:"tab",id:`tab-${n}`,"aria-selected":String(n===this.tab),"aria-controls":"panel",tabIndex:n===this.tab?0:-1,"data-key":`tab-${n}`,onkeydown:s=>this.along(s,e,n)}))),D("section",{className:"below"},this.tabs,this.panel)}along(e,t,n){const s={ArrowRight:1,ArrowLeft:-1}[e.key];if(!s)return;e.preventDefault(),e.stopPropagation();const o=t[(t.indexOf(n)+s+t.length)%t.length];this.open(o),document.getElementById(`tab-${o}`)?.focus()}invitation(){return this.newcomer?st(N("newHere"),()=>this.bring("Tour"),{"data-key":"invitation"}):null}bring(e){this.open(e),Gs.matches&&this.tabs.scrollIntoView(),document.getElementById(`tab-${e}`)?.scrollIntoView({block:"nearest",inline:"center"})}certificate(){this.open("Controller"),this.panel.querySelector(".light h4")?.scrollIntoView({block:Gs.matches?"start":"nearest"})}greeted(){this.newcomer=!1,os.setItem("toured","yes"),this.app.querySelector("[data-key=invitation]")?.remove()}open(e){this.tab=e,this.greeted();for(const t of this.tabs.querySelectorAll("[role=tab]")){const n=t.id===`tab-${e}`;t.setAttribute("aria-selected",String(n)),t.tabIndex=n?0:-1}this.panel.setAttribute("aria-labelledby",`tab-${e}`),this.fill()}fill(){if(!R.catalogue||!R.changed)return;const e={Controller:this.controller,Robot:this.robot,Kit:this.kit,See:this.see,Identify:this.identify,Keep:this.keep,Tour:this.tour,Class:this.classes,Python:this.python}[this.tab];Hs(()=>{Yt&&e===this.keep?this.keep.buildExported():e.build(),$e(this.panel,e.root)})}rebuild(){this.shape="",this.follow(),this.fill(),this.lamp()}follow(){const e=R.changed;if(!e)return;const t=JSON.stringify([e.bodies,e.look]);t!==this.shape&&(this.shape=t,this.room.furnish(e.look,e.bodies),this.charts.build())}hear(e){switch(e.kind){case"Welcome":this.timing=!Yt&&!R.recorded,Hs(()=>this.build());break;case"Catalogue":this.fill();break;case"Changed":{const t=!this.panel.firstChild;this.follow(),!this.begun&&!Yt&&this.link(),this.begun=!0,t?this.fill():this.update(),this.lamp(),this.champion(),this.identify.changed();const n=this.busy&&!e.busy;this.prepared=n&&this.tour.designed(),e.busy!==this.busy&&this.rest();break}case"Analysed":case"Light":this.lamp(),this.update();break;case"Equations":this.tab==="See"&&this.see.show();break;case"Snapshot":this.transported();break;case"Progress":if(e.job==="light"){this.lamp(),this.update();break}this.identify.progress(e.job,e.fraction),e.job==="certify"&&this.controller.certifying(e.fraction);break;case"JobResult":this.identify.found(),e===R.certified&&this.controller.certify(),(e!==R.certified||this.tab!=="Controller")&&this.toast(()=>`${N(e.job)}: ${Bt(e.title)}`,e.ok?"info":e.job==="certify"?"error":"warn"),ks&&this.tab==="Identify"&&Hs(()=>this.identify.build());break;case"Made":if(e.name===wc){this.compared(R.files+e.url);break}this.keep.made(e.name,e.url.startsWith("blob:")?e.url:R.files+e.url),this.toast(()=>N("made",{name:e.name}),"info");break;case"Notice":e.key==="lies"?this.lie(()=>N("lies")):e.job?this.failed(e.job,e.text):this.toast(()=>e.key?fn(e.key):Na(e.text),e.level);break;case"Recovered":this.recovered(e);break;case"Board":this.tab==="Class"&&this.classes.update();break}}update(){this.tab==="See"&&this.see.show(),{Controller:this.controller,Robot:this.robot,Kit:this.kit,Python:this.python}[this.tab]?.update()}lamp(){const e=am();if(this.app.classList.toggle("loose",R.falls||(R.changed?.busy??!1)),R.recorded&&(R.lit?.light??"none")==="none")return $e(this.light);const t=lm()[1]?.textContent??"";this.light.title=`${t[0].toUpperCase()}${t.slice(1)}. ${N("lightNote")}`;const n=R.setup.controller==="off"?t:t.split(",")[0]+rm().split(",").slice(0,2).join();$e(this.light,D("span",{className:`lamp ${e}`,"aria-hidden":"true"}),D("span",{className:"word","aria-hidden":"true"},e==="none"?"…":N(e).split(",")[0]),D("span",{},`${N("certificate")}:`),D("span",{},n))}recovered({impulse:e,fell:t,single:n}){const s=this.driven(),o=this.best[s]??0,r=Math.max(o,n&&!t?e:0);this.prepared=!1,r&&(this.best[s]=r),this.champion();const a=()=>({impulse:at(e),best:at(r)});if(t&&(this.lost=()=>N(n?"lostPush":"lostPushes",a())),this.down)return this.lie();t||(this.tell(hn(()=>N(n?r<o*(1+L3)?"recovered":"recoveredMost":"recoveredSeveral",a()))),this.telling=window.setTimeout(()=>this.rest(),6e3))}compared(e){this.identify.compared(e),this.tab!=="Identify"&&this.toast(()=>N("comparedThere"),"info")}failed(e,t){const n=e.startsWith("keep compar")?"compare":e,s=["doctor","calibrate","compare"].includes(n),o=()=>s||e==="certify"?NA(n,t):Na(t);s&&this.identify.fail(o),(!s||this.tab!=="Identify")&&this.toast(o,"error")}driven(){return`${R.setup.robot} ${R.setup.controller}`}champion(){const e=this.best[this.driven()];this.most.textContent=e?N("best",{best:at(e)}):"",this.most.title=N("bestTip")}tell(...e){window.clearTimeout(this.telling),$e(this.fell,...e)}rest(){if(this.busy=R.changed?.busy??!1,this.down)return;const e=()=>[N("designing"),R.setup.controller==="robust"?N("robustTakes"):""].join(" ").trim();this.tell((this.busy||this.prepared)&&hn(()=>this.busy?e():N("designed")))}lie(e=this.lost??(()=>N("fallen"))){const t=D("button",{type:"button",className:"main",onclick:()=>this.stand()},hn(()=>N("standUp")));this.tell(hn(e),!R.recorded&&t)}transported(){const e=R.snapshot;if(!e)return;this.timing&&R.send({kind:"Play",paused:e.paused,speed:this.speed}),this.timing=!1;const t=e.paused?N("play"):N("pause");this.pauseButton.textContent!==t&&(this.pauseButton.textContent=t),R.recorded?this.timed(e.t):document.activeElement!==this.scrub&&(this.scrub.min=String(-Math.min(Math.max(Math.ceil(e.t+e.back-(R.traces.t[0]??e.t)),1),60)),this.scrub.value=String(-e.back)),this.clock.textContent=`${oi(e.t,1)} ${R.recorded?`/ ${oi(R.recorded,1)} `:""}s`;const n=!!e.x[0][8];n!==this.down&&(n||(this.lost=null),this.down=n,n?this.lie():this.rest(),this.app.querySelector("[data-key=impulse]")?.classList.toggle("main",!n));const s=e.f[0],o=e.f[2]?`${N("slope")}: ${Nh(e.f[2])}`:"";R.traces.marks.some(({what:r})=>!bc.includes(r))&&this.app.classList.add("pushed"),this.force.textContent=Math.abs(s)>.005?N("newtons",{force:oi(s,2)}):o,this.force.classList.toggle("slope",!(Math.abs(s)>.005))}timed(e){this.scrub.matches(":active")||(this.scrub.value=String(e)),this.scrub.setAttribute("aria-valuetext",`${oi(e,1)} s`)}seek(e){const[t,n]=[R.snapshot,R.recorded||60],s=(R.recorded?R.recorded-(t?.t??0):t?.back??0)-e;R.send({kind:"Scrub",back:Math.max(0,Math.min(n,s))})}stand(){R.send({kind:"StandUp",pitch:R.falls?el:0}),R.send({kind:"Play",paused:!1,speed:this.speed})}pause(){R.send({kind:"Play",paused:!R.snapshot?.paused,speed:this.speed})}says(e,t=""){e==="lost"&&this.state!=="lost"&&(this.waits=window.setTimeout(()=>this.tell(hn(()=>N("gone"))),N3)),e==="connected"&&this.state==="lost"&&this.back(),this.state=e;const n={connecting:N("connecting"),connected:N("connected"),lost:N("lost"),refused:N("refused"),replaying:N("replaying")};this.status.className=`status ${e}`,this.status.textContent=n[e],e==="refused"&&(Fi.removeItem("name"),$e(this.app,D("main",{className:"refused",role:"alert"},D("h1",{},N("refused")),D("p",{},Bt(t)),st("↻",()=>location.reload()))))}back(){window.clearTimeout(this.waits),this.down?this.lie():this.rest()}toast(e,t){if(this.toasts.lastElementChild?.firstElementChild?.textContent===e())return;const n=D("button",{type:"button",onclick:()=>s.remove()},D("span",{"aria-hidden":"true"},"×"),D("span",{className:"hidden"},hn(()=>N("close")))),s=D("div",{className:`toast ${t}`},hn(e),n);this.toasts.querySelectorAll(t==="error"?".toast.error":".toast:not(.error)").forEach(o=>o.remove()),this.toasts.append(s),window.setTimeout(()=>s.remove(),t==="error"?15e3:6e3)}speak(e){hd(e),os.setItem("language",e),this.build(),this.says(this.state),Da(this.app),this.describe(),this.app.querySelector("[data-key=language]")?.focus()}theme(e){const t=e?e==="dark":matchMedia("(prefers-color-scheme: dark)").matches;document.documentElement.dataset.theme=t?"dark":"light",e&&os.setItem("theme",e),this.room.paint(),R.changed&&this.charts.build(),this.panel.firstChild&&this.fill()}help(){const e=["impulse","size","front","back","pull","tilt","step"].map(h=>[N(h==="pull"?"pullBoth":h==="back"?"backPush":h),N(`${h}Tip`)]),[t,n,s,...o]=Ph().keys,a=(matchMedia("(hover: none)").matches?[s,...e]:[...e,t,n,s,...o]).map(([h,u])=>D("tr",{},D("th",{scope:"row"},h),D("td",{},u))),l=D("h2",{tabIndex:-1},N("help")),c=D("dialog",{className:"help","aria-label":N("help"),onclose:()=>c.remove()},l,D("table",{},D("tbody",{},...a)),D("div",{className:"foot"},st(N("close"),()=>c.close(),{className:"main"})));this.app.append(c),c.showModal(),l.focus(),c.scrollTop=0}key(e){const t=e.target;if(!(e.ctrlKey||e.metaKey||e.altKey||/^(INPUT|SELECT|TEXTAREA|DIALOG)$/.test(t.tagName))&&!(e.key===" "&&t.tagName==="BUTTON")){if(e.key==="?")this.help();else if(e.key===" ")this.pause();else if(e.key===".")R.send({kind:"Step",periods:1});else if(e.key===","||e.key==="/")this.seek(e.key===","?-.25:.25);else if(e.key==="s")this.stand();else if(e.key==="n"||e.key==="p")this.toured(e.key==="n"?1:-1);else if(e.key==="k")this.strike();else if(/^[1-8]$/.test(e.key)&&document.getElementById(`tab-${this.tabAt(e.key)}`))this.open(this.tabAt(e.key));else return;e.preventDefault()}}tabAt(e){return(Yt?ep:Qf)[Number(e)-1]}toured(e){const t=this.tab==="Tour";t||this.open("Tour"),this.tour.move(t?e:0)}look(e){const t={"[":[-.15,0],"]":[.15,0],"{":[0,-.1],"}":[0,.1]};e.key in t&&this.room.turn(...t[e.key]),e.key==="+"&&this.room.zoom(.9),e.key==="-"&&this.room.zoom(1.1)}frame(e){R.snapshot&&this.room.move(R.snapshot),this.room.draw(e-this.drawn),this.drawnFirst&&e>this.seen+D3?this.deepen():R.snapshot&&!this.drawnFirst&&([this.drawnFirst,this.seen]=[!0,e]),this.drawn=e,e-this.plotted>45&&(this.charts.draw(),this.tab==="See"&&this.see.draw(),this.plotted=e),e-this.said>2e3&&(this.describe(),this.said=e),this.steering.tick(e),requestAnimationFrame(t=>this.frame(t))}describe(){const[e,t]=[R.snapshot,R.changed];if(!e||!t)return;const n=fn(t.bodies[0]),s=oi(t.look.wheel_radius*e.x[0][2]*100,0),o=e.x[0][8]?N("fellNow",{body:n}):N("sceneNow",{body:n,pitch:oi(e.x[0][0]*180/Math.PI,1),way:s});this.spoken.textContent=o,this.room.element.setAttribute("aria-label",`${N("scene")} ${o}`)}picture(){return this.room.picture([R.setup.robot,fn(R.setup.controller),`${oi(R.snapshot?.t??0,1)} s`,"upright lab"].join("  ·  "))}address(){return zh()}grasp(){return this.room.grasp()}}const U3=new k3(document.getElementById("app"));Object.assign(window,{upright:{store:R,page:U3,exported:Yt}});
